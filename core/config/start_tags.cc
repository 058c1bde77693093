// SPDX-License-Identifier: BSD-3-Clause
#include "core/config/start_tags.h"

#include <utility>

namespace latchwork::config {
namespace {

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool EndsName(char c) { return IsSpace(c) || c == '=' || c == '/' || c == '>'; }

}  // namespace

StartTag StartTags::Take() {
  StartTag taken = std::move(next_);
  Advance();
  return taken;
}

void StartTags::Advance() {
  next_ = StartTag{{0, 0, 0}, {}};
  while (!Done()) {
    if (At("<!--")) {
      SkipPast("-->");
    } else if (At("<![CDATA[")) {
      SkipPast("]]>");
    } else if (At("<?")) {
      SkipPast("?>");
    } else if (At("</") || At("<!")) {
      SkipPast(">");
    } else if (At("<")) {
      ReadTag();
      return;
    } else {
      Step();
    }
  }
}

void StartTags::Step() {
  const auto c = static_cast<unsigned char>(text_[offset_++]);
  if (c == '\n' || (c == '\r' && !At("\n"))) {
    position_ = {position_.line + 1, 1, 1};
    return;
  }
  ++position_.column;
  const bool continues = (c & 0xc0U) == 0x80U;
  if (!continues) position_.unit += c >= 0xf0U ? 2 : 1;
}

void StartTags::SkipPast(std::string_view word) {
  while (!Done() && !At(word)) Step();
  for (std::size_t i = 0; i < word.size() && !Done(); ++i) Step();
}

void StartTags::ReadTag() {
  next_.position = position_;
  while (!Done() && !EndsName(text_[offset_])) Step();
  while (!Done() && !At(">")) {
    if (IsSpace(text_[offset_]) || At("/")) {
      Step();
    } else {
      ReadAttribute();
    }
  }
  if (!Done()) Step();
}

void StartTags::ReadAttribute() {
  AttributeSpan span;
  span.name_position = position_;
  const std::size_t begin = offset_;
  while (!Done() && !EndsName(text_[offset_])) Step();
  span.name = text_.substr(begin, offset_ - begin);
  while (!Done() && (IsSpace(text_[offset_]) || At("="))) Step();
  if (Done() || (!At(R"(")") && !At("'"))) return;
  const std::string_view quote = text_.substr(offset_, 1);
  Step();
  span.value_position = position_;
  SkipPast(quote);
  next_.attributes.push_back(span);
}

}  // namespace latchwork::config
