// What search engines and feed readers are told of a site: its permanent addresses, and what is
// new.
#pragma once

#include <string>
#include <vector>

#include "changeover/catalog/catalog.hpp"
#include "changeover/core/parameters.hpp"

namespace changeover::serve {

/// "https://example.org/designs/" as it must be: absolute, of http or https, with a slash at the
/// end, without a query.
/// @throws cli::UsageError in one line otherwise.
[[nodiscard]] std::string site_address(const std::string& given);

/// Where the program is: an address of the same form, as it is given. @throws the same.
[[nodiscard]] std::string sources_address(const std::string& given);

/// The permanent address of a cell, and of a design by its label.
[[nodiscard]] std::string address_of_cell(const std::string& site, const Parameters& p);
[[nodiscard]] std::string address_of_design(const std::string& site, const std::string& label);

/// A sitemap (sitemaps.org) of at most 50,000 addresses.
inline constexpr std::size_t most_addresses = 50'000;
[[nodiscard]] std::string sitemap(const std::vector<std::string>& addresses);
/// One of sitemaps.
[[nodiscard]] std::string sitemap_index(const std::vector<std::string>& sitemaps);

/// An Atom feed of the designs that came last to the catalog, latest first.
[[nodiscard]] std::string feed(const std::string& site, const Catalog& catalog);

}  // namespace changeover::serve
