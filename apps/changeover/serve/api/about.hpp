// What is known in general, as JSON.
#pragma once

#include <string>
#include <string_view>

namespace changeover::serve {

/// atlas_json() of stored_cells() for each change number and kind, a line each; generated. Empty in
/// builds that are not optimised.
[[nodiscard]] std::string_view stored_atlases();

/// [{"number","title","statement","proof","example":{v,k,change,kind}|null}]
[[nodiscard]] std::string theorems_json();

/// [{"name","summary","citation","serves","gives","example":{v,k,change,kind}|null}]
[[nodiscard]] std::string constructions_json();

}  // namespace changeover::serve
