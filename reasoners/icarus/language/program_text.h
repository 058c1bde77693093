// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_PROGRAM_TEXT_H_
#define LATCHWORK_ICARUS_PROGRAM_TEXT_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// A program put together from several texts, one after the other, each with places of its own.
class ProgramText {
 public:
  /// Appends a text. Errors of syntax are findings, and then nothing is added.
  void Add(std::string text, std::string file, Findings& findings);
  /// Appends a text whose skills, constants and top replace those of the same names.
  void Tell(std::string text, std::string file, Findings& findings);
  /// Takes out the skill or constant of this name, in any case. False: there is none.
  bool Remove(std::string_view name);

  /// Reads and checks the whole.
  ProgramFile Read(const CheckOptions& options = {}) const;
  /// Offset in the whole at which the text added last begins.
  std::uint32_t last_begin() const;

 private:
  struct Part {
    std::string file;
    std::string text;  ///< What was taken out is blank, so that the rest keeps its places.
  };
  static bool Blank(Part& part, std::string_view name);
  void Append(std::string text, std::string file, bool replace, Findings& findings);

  std::vector<Part> parts_;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_PROGRAM_TEXT_H_
