// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_XML_H_
#define LATCHWORK_CONFIG_XML_H_

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/diagnostic.h"

namespace latchwork::config {

struct Attribute {
  std::string name;
  std::string value;
  logic::SourcePlace name_place;
  logic::SourcePlace place;  ///< Of the first character of the value.
};

/// An XML element with its place. Attribute order is the file's.
struct Element {
  std::string name;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string text;          ///< Character data, trimmed.
  logic::SourcePlace place;  ///< Of the start tag.

  /// The attribute of this name, or null.
  const Attribute* Find(std::string_view attribute) const;
};

struct XmlFile {
  Element root;
  logic::Diagnostics diagnostics;
  std::string bytes;       ///< The text of the file, for fingerprints and excerpts.
  bool complete = false;   ///< `root` is the whole file: it could be read to its end.
  bool has_reader = true;  ///< False: the installation lacks what reads XML, and no file is wrong.
};

/// What the text in one file may not exceed.
inline constexpr std::size_t kMaxXmlBytes = 16U << 20U;
inline constexpr std::size_t kMaxXmlDepth = 256;
inline constexpr std::size_t kMaxXmlElements = 20'000;

/// Parses a file and validates it against a schema (Xerces-C, SAX2); an empty schema allows
/// anything. UTF-8 only. A document type declaration is refused and nothing outside the file is
/// ever fetched. All errors at once, each with its place; after what breaks the syntax nothing more
/// is read. Attributes of the namespaces xmlns and xsi are left out. An element of a namespace is
/// called {namespace}name. Thread rule: safe from any thread.
XmlFile ReadXml(const std::filesystem::path& file, std::string_view schema);
XmlFile ReadXmlText(std::string_view text, std::string_view name, std::string_view schema);

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_XML_H_
