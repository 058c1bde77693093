// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_CONFIG_START_TAGS_H_
#define LATCHWORK_CONFIG_START_TAGS_H_

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace latchwork::config {

/// A position in a UTF-8 text. Lines count as XML counts them: LF, CR LF and CR end one.
struct TextPosition {
  std::uint32_t line = 1;
  std::uint32_t column = 1;  ///< In bytes.
  std::uint32_t unit = 1;    ///< In UTF-16 code units, which is what Xerces counts.
};

struct AttributeSpan {
  std::string_view name;
  TextPosition name_position;
  TextPosition value_position;  ///< Of the first character of the value.
};

struct StartTag {
  TextPosition position;  ///< Of the '<'.
  std::vector<AttributeSpan> attributes;
};

/// Finds the start tags of an XML text one after the other. Xerces tells where a tag ends; a person
/// wants to see where it, or one of its attributes, begins. Expects well-formed text; on other text
/// it stops or finds nonsense, in time linear in its length.
class StartTags {
 public:
  explicit StartTags(std::string_view text) : text_(text) { Advance(); }

  /// The next start tag that was not taken; its line is 0 when there is none.
  const StartTag& next() const { return next_; }
  StartTag Take();

 private:
  void Advance();
  bool At(std::string_view word) const { return text_.substr(offset_, word.size()) == word; }
  bool Done() const { return offset_ >= text_.size(); }
  void Step();
  void SkipPast(std::string_view word);
  void ReadTag();
  void ReadAttribute();

  std::string_view text_;
  std::size_t offset_ = 0;
  TextPosition position_;
  StartTag next_;
};

}  // namespace latchwork::config

#endif  // LATCHWORK_CONFIG_START_TAGS_H_
