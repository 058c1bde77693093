// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ARGUMENT_CHECK_H_
#define LATCHWORK_ICARUS_ARGUMENT_CHECK_H_

#include <span>
#include <string_view>

#include "reasoners/icarus/language/finding.h"
#include "reasoners/icarus/language/program.h"
#include "reasoners/icarus/language/signature.h"

namespace latchwork::icarus {

/// The signature of this name that takes so many arguments; else the first of this name; null when
/// there is none.
const Signature* FindSignature(std::span<const Signature> signatures, std::string_view name,
                               std::size_t arguments);

/// Whether a term, as written, can never be of the type.
bool Offends(const Program& program, const Term& term, ArgumentType type);

/// Reports a call, a term of kind kCall, whose number of arguments is wrong, or one of whose
/// arguments, as written, can never be of its type.
void CheckArguments(const Program& program, const Term& call, const Signature& signature,
                    Reporter& reporter);

/// Reports an argument of a call of this signature that calls one of the functions, whose answers
/// are never of the type.
void CheckNested(const Term& call, const Signature& signature, std::span<const Signature> functions,
                 Reporter& reporter);

/// Reports a target of bind that the answer of a call, a function of this signature, never fits.
void CheckTarget(const Program& program, const Term& target, const Term& call,
                 const Signature& signature, Reporter& reporter);

/// Reports a match form for facts of this signature that can never succeed.
void CheckPattern(const Program& program, const Clause& match, const Signature& signature,
                  Reporter& reporter);

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ARGUMENT_CHECK_H_
