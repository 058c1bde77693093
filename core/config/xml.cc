// SPDX-License-Identifier: BSD-3-Clause
// The only file that knows Xerces.
#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <utility>
#include <xercesc/framework/MemBufInputSource.hpp>
#include <xercesc/framework/XMLGrammarPoolImpl.hpp>
#include <xercesc/sax2/Attributes.hpp>
#include <xercesc/sax2/DefaultHandler.hpp>
#include <xercesc/sax2/SAX2XMLReader.hpp>
#include <xercesc/sax2/XMLReaderFactory.hpp>
#include <xercesc/util/PlatformUtils.hpp>
#include <xercesc/util/TransService.hpp>
#include <xercesc/util/XMLUni.hpp>
#include <xercesc/validators/common/Grammar.hpp>

#include "core/config/explain.h"
#include "core/config/read_bytes.h"
#include "core/config/schema_index.h"
#include "core/config/start_tags.h"
#include "core/config/xml_module.h"
#include "latchwork/config/agent.h"

namespace latchwork::config {
namespace {

namespace xml = XERCES_CPP_NAMESPACE;

/// Xerces is started by the first file that is read and ended with the process.
class Runtime {
 public:
  Runtime() { xml::XMLPlatformUtils::Initialize(); }
  ~Runtime() { xml::XMLPlatformUtils::Terminate(); }
  Runtime(const Runtime&) = delete;
  Runtime& operator=(const Runtime&) = delete;
};

std::string Utf8(const XMLCh* text) {
  if (text == nullptr || *text == 0) return "";
  const xml::TranscodeToStr utf8(text, "UTF-8");
  return {reinterpret_cast<const char*>(utf8.str()), utf8.length()};
}

std::string Trim(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// Ends the parse; what is wrong has been noted.
struct Refused {};

/// Builds the tree and keeps what the validator says against it.
class TreeBuilder : public xml::DefaultHandler {
 public:
  TreeBuilder(std::string_view text, std::string_view name)
      : text_(text), name_(name), tags_(text) {}

  Element root;
  Complaints complaints;
  logic::Diagnostics diagnostics;

  void startElement(const XMLCh* uri, const XMLCh* local, const XMLCh* /*qualified*/,
                    const xml::Attributes& attributes) override {
    const StartTag tag = tags_.Take();
    Element element;
    const std::string space = Utf8(uri);
    element.name = space.empty() ? Utf8(local) : fmt::format("{{{}}}{}", space, Utf8(local));
    element.place = Place(tag.position);
    for (XMLSize_t i = 0; i < attributes.getLength(); ++i) {
      AddAttribute(attributes, i, tag, element);
    }
    open_.push_back(std::move(element));
    if (open_.size() > kMaxXmlDepth) {
      Refuse(open_.back().place,
             fmt::format("elements are nested more than {} deep", kMaxXmlDepth));
    }
    if (++count_ > kMaxXmlElements) {
      Refuse(open_.back().place,
             fmt::format("the file has more than {} elements", kMaxXmlElements));
    }
  }

  void endElement(const XMLCh* /*uri*/, const XMLCh* /*local*/,
                  const XMLCh* /*qualified*/) override {
    CloseElement();
  }

  void characters(const XMLCh* chars, XMLSize_t length) override {
    if (!open_.empty()) open_.back().text += Utf8(std::basic_string<XMLCh>(chars, length).c_str());
  }

  void startDTD(const XMLCh* /*name*/, const XMLCh* /*public_id*/,
                const XMLCh* /*system_id*/) override {
    const std::size_t offset = text_.find("<!DOCTYPE");
    Refuse(PlaceOfOffset(offset), "a document type declaration (<!DOCTYPE ...>) is not allowed");
  }

  void warning(const xml::SAXParseException& /*exception*/) override {}

  void error(const xml::SAXParseException& exception) override {
    const TextPosition& next = tags_.next().position;
    const auto line = static_cast<std::uint32_t>(exception.getLineNumber());
    const auto unit = static_cast<std::uint32_t>(exception.getColumnNumber());
    const bool in_next_tag =
        next.line != 0 && std::pair(line, unit) > std::pair(next.line, next.unit);
    if (in_next_tag) {
      complaints[{next.line, next.column}].push_back(Utf8(exception.getMessage()));
    } else if (!open_.empty()) {
      const logic::SourcePlace& place = open_.back().place;
      complaints[{place.line, place.column}].push_back(Utf8(exception.getMessage()));
    }
  }

  void fatalError(const xml::SAXParseException& exception) override {
    const auto line = static_cast<std::uint32_t>(exception.getLineNumber());
    const auto unit = static_cast<std::uint32_t>(exception.getColumnNumber());
    Refuse({name_, line, ByteColumn(line, unit)},
           "this is not well-formed XML: " + Utf8(exception.getMessage()));
  }

  /// Closes what is still open, after a parse that was broken off.
  void CloseAll() {
    while (!open_.empty()) CloseElement();
  }

 private:
  [[noreturn]] void Refuse(logic::SourcePlace place, std::string message) {
    diagnostics.push_back({std::move(place), std::move(message), "", ""});
    throw Refused();
  }

  logic::SourcePlace Place(const TextPosition& position) const {
    return {name_, position.line, position.column};
  }

  void AddAttribute(const xml::Attributes& attributes, XMLSize_t index, const StartTag& tag,
                    Element& element) const {
    const std::string name = Utf8(attributes.getQName(index));
    if (name == "xmlns" || name.starts_with("xmlns:") || name.starts_with("xsi:")) return;
    Attribute attribute{name, Utf8(attributes.getValue(index)), element.place, element.place};
    for (const AttributeSpan& span : tag.attributes) {
      if (span.name != name) continue;
      attribute.name_place = Place(span.name_position);
      attribute.place = Place(span.value_position);
    }
    element.attributes.push_back(std::move(attribute));
  }

  void CloseElement() {
    Element element = std::move(open_.back());
    open_.pop_back();
    element.text = Trim(element.text);
    if (open_.empty()) {
      root = std::move(element);
    } else {
      open_.back().children.push_back(std::move(element));
    }
  }

  logic::SourcePlace PlaceOfOffset(std::size_t offset) const {
    TextPosition position;
    for (std::size_t i = 0; i < offset && i < text_.size(); ++i) {
      position.column = text_[i] == '\n' ? 1 : position.column + 1;
      position.line += text_[i] == '\n' ? 1 : 0;
    }
    return Place(position);
  }

  std::uint32_t ByteColumn(std::uint32_t line, std::uint32_t unit) const {
    std::size_t offset = 0;
    for (std::uint32_t i = 1; i < line && offset != std::string_view::npos; ++i) {
      offset = text_.find('\n', offset);
      if (offset != std::string_view::npos) ++offset;
    }
    if (offset == std::string_view::npos) return unit;
    std::uint32_t column = 1;
    for (std::uint32_t at = 1; at < unit && offset < text_.size(); ++column) {
      const auto next = ++offset < text_.size() ? static_cast<unsigned char>(text_[offset]) : 0U;
      if ((next & 0xc0U) != 0x80U) ++at;
    }
    return column;
  }

  std::string_view text_;
  std::string name_;
  StartTags tags_;
  std::vector<Element> open_;
  std::size_t count_ = 0;
};

using Reader = std::unique_ptr<xml::SAX2XMLReader>;

xml::MemBufInputSource Source(std::string_view text, const char* name) {
  return {reinterpret_cast<const XMLByte*>(text.data()), text.size(), name};
}

void Start() { static const Runtime runtime; }

/// `pool` holds the grammar to validate against; null: no validation.
Reader MakeReader(xml::XMLGrammarPool* pool) {
  Start();
  Reader reader(
      xml::XMLReaderFactory::createXMLReader(xml::XMLPlatformUtils::fgMemoryManager, pool));
  reader->setFeature(xml::XMLUni::fgSAX2CoreNameSpaces, true);
  reader->setFeature(xml::XMLUni::fgSAX2CoreValidation, pool != nullptr);
  reader->setFeature(xml::XMLUni::fgXercesDynamic, false);
  reader->setFeature(xml::XMLUni::fgXercesSchema, pool != nullptr);
  return reader;
}

/// True when the text was read to its end.
bool Parse(std::string_view text, xml::XMLGrammarPool* pool, TreeBuilder& builder) {
  const Reader reader = MakeReader(pool);
  reader->setFeature(xml::XMLUni::fgXercesUseCachedGrammarInParse, true);
  reader->setFeature(xml::XMLUni::fgXercesLoadSchema, false);
  reader->setFeature(xml::XMLUni::fgXercesDisableDefaultEntityResolution, true);
  reader->setContentHandler(&builder);
  reader->setErrorHandler(&builder);
  reader->setLexicalHandler(&builder);
  auto source = Source(text, "text");
  source.setEncoding(xml::XMLUni::fgUTF8EncodingString);
  try {
    reader->parse(source);
    return true;
  } catch (const Refused&) {
  } catch (const xml::XMLException& exception) {
    builder.diagnostics.push_back({builder.root.place, Utf8(exception.getMessage()), "", ""});
  } catch (const xml::SAXException& exception) {
    builder.diagnostics.push_back({builder.root.place, Utf8(exception.getMessage()), "", ""});
  }
  builder.CloseAll();
  return false;
}

/// A schema, ready to validate any number of texts, one at a time: the first element of each type
/// completes what is known of the type, although the pool is locked.
class Grammar {
 public:
  explicit Grammar(std::string_view schema) {
    Start();
    pool_ = std::make_unique<xml::XMLGrammarPoolImpl>(xml::XMLPlatformUtils::fgMemoryManager);
    const auto source = Source(schema, "schema");
    // Not with entity resolution disabled: that would silently load nothing.
    MakeReader(pool_.get())->loadGrammar(source, xml::Grammar::SchemaGrammarType, true);
    pool_->lockPool();
    TreeBuilder builder(schema, "schema");
    Parse(schema, nullptr, builder);
    index_ = IndexSchema(builder.root);
  }

  xml::XMLGrammarPool* pool() const { return pool_.get(); }
  const SchemaIndex& index() const { return index_; }
  std::mutex& mutex() const { return mutex_; }  ///< To be held while a text is validated.

 private:
  std::unique_ptr<xml::XMLGrammarPoolImpl> pool_;
  SchemaIndex index_;
  mutable std::mutex mutex_;
};

/// Null for no schema. That of agent files is made once.
std::shared_ptr<const Grammar> MakeGrammar(std::string_view schema) {
  if (schema.empty()) return nullptr;
  if (schema != AgentSchema()) return std::make_shared<const Grammar>(schema);
  Start();
  static const auto grammar = std::make_shared<const Grammar>(AgentSchema());
  return grammar;
}

void Read(XmlFile& file, std::string_view name, std::string_view schema) {
  std::string_view text = file.bytes;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const auto grammar = MakeGrammar(schema);
  TreeBuilder builder(text, name);
  if (grammar == nullptr) {
    file.complete = Parse(text, nullptr, builder);
  } else {
    const std::lock_guard lock(grammar->mutex());
    file.complete = Parse(text, grammar->pool(), builder);
  }
  file.root = std::move(builder.root);
  if (!builder.complaints.empty() && grammar != nullptr) {
    file.diagnostics = Explain(file.root, grammar->index(), builder.complaints);
  }
  for (auto& diagnostic : builder.diagnostics) file.diagnostics.push_back(std::move(diagnostic));
}

}  // namespace
}  // namespace latchwork::config

extern "C" void latchwork_parse_xml(latchwork::config::XmlFile& file, std::string_view name,
                                    std::string_view schema) {
  latchwork::config::Read(file, name, schema);
}
