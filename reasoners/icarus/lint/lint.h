// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_LINT_H_
#define LATCHWORK_ICARUS_LINT_H_

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"

namespace latchwork::icarus {

/// Arguments of skills and functions; match forms that look like calls; changes of memory in
/// conditions.
void LintCalls(const Program& program, const CheckOptions& options, Reporter& reporter,
               Findings& findings);

/// Arguments of skills against what the skills do with them.
void LintTypes(const Program& program, Reporter& reporter);

/// Variables that stand once, or that nothing binds where a value is needed.
void LintVariables(const Program& program, const CheckOptions& options, Reporter& reporter);

/// Skills that are never reached, never act, hide others, or never end.
void LintSkills(const Program& program, const CheckOptions& options, Reporter& reporter);

/// Skills that call themselves with their own arguments, directly or through others.
void LintRecursion(const Program& program, Reporter& reporter);

/// Names spelt with different letters in upper and lower case.
void LintSpelling(const Program& program, Reporter& reporter);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_LINT_H_
