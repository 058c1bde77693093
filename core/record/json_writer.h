// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_RECORD_JSON_WRITER_H_
#define LATCHWORK_RECORD_JSON_WRITER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "latchwork/logic/atom.h"

namespace latchwork::record {

/// Writes JSON in one line into memory that it reuses. The caller keeps to the grammar; commas,
/// quotes and escapes are put here. What is no UTF-8 becomes U+FFFD.
class JsonWriter {
 public:
  void Clear() { text_.clear(); }
  const std::string& text() const { return text_; }

  void Begin(char bracket);
  void End(char bracket) { text_ += bracket; }
  void Key(std::string_view name);
  void Text(std::string_view text);
  void Number(std::uint64_t number);
  /// Not-a-number and the infinities become null.
  void Number(double number);
  void Boolean(bool value);
  void Fact(const logic::Fact& fact);
  void Facts(std::span<const logic::Fact> facts);

  /// A member whose list or object is filled by `fill`, or nothing at all when that adds nothing.
  template <typename Fill>
  void Member(std::string_view name, char open, char close, const Fill& fill) {
    const std::size_t mark = text_.size();
    Key(name);
    Begin(open);
    const std::size_t empty = text_.size();
    fill();
    if (text_.size() == empty) {
      text_.resize(mark);
    } else {
      End(close);
    }
  }

 private:
  void Separate();
  void Escape(std::string_view text);

  std::string text_;
  std::string fact_;
};

}  // namespace latchwork::record

#endif  // LATCHWORK_RECORD_JSON_WRITER_H_
