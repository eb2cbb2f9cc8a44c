#include "serve/export/addresses.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <algorithm>

#include "changeover/catalog/entry.hpp"
#include "cli/cli.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"

namespace changeover::serve {
namespace {

// A day as Atom wants a time.
std::string time_of(const std::string& day) {
  return (day.empty() ? std::string("2026-01-01") : day) + "T00:00:00Z";
}

bool is_plain(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    return is_letter(c) || is_digit(c) ||
           std::string_view(":/.-_~%").find(c) != std::string_view::npos;
  });
}

// "[2001:db8::1]"
bool is_ipv6(const std::string& name) {
  in6_addr address{};
  return name.size() > 2 && name.ends_with(']') &&
         ::inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), &address) == 1;
}

// "80", but not "0", "080" or "".
bool is_port(const std::string& text) {
  constexpr std::uint64_t most_port = 65'535;
  const auto port = parsed<std::uint64_t>(text);
  return port && *port >= 1 && *port <= most_port && text.front() != '0';
}

// @throws UsageError unless it is absolute, of http or https, without a query. `what` says what it
// should be.
void require_address(std::string_view option, const std::string& given, std::string_view what) {
  const bool absolute = given.starts_with("https://") || given.starts_with("http://");
  const std::size_t host = given.find("//") + 2;
  const auto refuse = [&](const std::string& why) {
    throw cli::UsageError{fmt::format("{} {}: {}", option, printable(given), why)};
  };
  const std::size_t path = absolute ? std::min(given.find('/', host), given.size()) : 0;
  if (!absolute || !is_plain(std::string_view(given).substr(path))) {
    refuse(fmt::format("write {}", what));
  }
  const std::string authority = given.substr(host, path - host);
  const bool is_bracketed = authority.starts_with('[');
  const std::size_t bracket = is_bracketed ? authority.find(']') : 0;
  const std::size_t colon = authority.find(':', std::min(bracket, authority.size()));
  const std::string name = authority.substr(0, colon);
  if (is_bracketed ? !is_ipv6(name) : name.empty() || !is_plain(name)) {
    refuse(fmt::format("write {}", what));
  }
  if (colon != std::string::npos && !is_port(authority.substr(colon + 1))) {
    refuse("a port is a number from 1 to 65535; correct it");
  }
}

}  // namespace

std::string site_address(const std::string& given) {
  require_address("--address", given, "where the site will be, as https://example.org/designs/");
  return given.ends_with('/') ? given : given + "/";
}

std::string sources_address(const std::string& given) {
  require_address("--sources", given,
                  "where the program can be got, as https://example.org/changeover");
  return given;
}

std::string address_of_cell(const std::string& site, const Parameters& p) {
  return site + "?cell=" + cell_label(p);
}

std::string address_of_design(const std::string& site, const std::string& label) {
  return site + "?design=" + label;
}

std::string sitemap(const std::vector<std::string>& addresses) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n";
  for (const std::string& address : addresses) {
    text += "<url><loc>" + html_text(address) + "</loc></url>\n";
  }
  return text + "</urlset>\n";
}

std::string sitemap_index(const std::vector<std::string>& sitemaps) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<sitemapindex xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n";
  for (const std::string& address : sitemaps) {
    text += "<sitemap><loc>" + html_text(address) + "</loc></sitemap>\n";
  }
  return text + "</sitemapindex>\n";
}

std::string feed(const std::string& site, const Catalog& catalog) {
  constexpr std::size_t most_entries = 100;
  std::vector<CatalogEntry> latest;
  catalog.each({.best_only = true}, [&](const CatalogEntry& entry) {
    latest.push_back(entry);
    return true;
  });
  const auto newer = [](const CatalogEntry& a, const CatalogEntry& b) {
    return a.credit.date != b.credit.date ? a.credit.date > b.credit.date : a.label() < b.label();
  };
  const std::size_t shown = std::min(most_entries, latest.size());
  std::partial_sort(latest.begin(), latest.begin() + static_cast<std::ptrdiff_t>(shown),
                    latest.end(), newer);
  latest.resize(shown);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<feed xmlns=\"http://www.w3.org/2005/Atom\">\n"
      "<title>Changeover: new designs</title>\n<id>{0}</id>\n<link href=\"{0}\"/>\n"
      "<link rel=\"self\" href=\"{0}feed.xml\"/>\n<updated>{1}</updated>\n",
      html_text(site), time_of(latest.empty() ? "" : latest.front().credit.date));
  for (const CatalogEntry& entry : latest) {
    const std::string address = html_text(address_of_design(site, entry.label()));
    text += fmt::format(
        "<entry><title>{}: {}</title><id>{}</id><link href=\"{}\"/><updated>{}</updated>"
        "<author><name>{}</name></author><summary>{} by {}; lower bound {}.</summary></entry>\n",
        html_text(name(entry.parameters)), count_of(entry.b, "block"), address, address,
        time_of(entry.credit.date),
        html_text(entry.credit.who.empty() ? "unknown" : entry.credit.who),
        entry.b == entry.lower_bound ? "Minimum," : "Made", html_text(entry.recipe.construction),
        entry.lower_bound);
  }
  return text + "</feed>\n";
}

}  // namespace changeover::serve
