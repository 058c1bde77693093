// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_ATTACHMENT_H_
#define LATCHWORK_SDK_ATTACHMENT_H_

#include <span>
#include <string>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/term.h"
#include "latchwork/sdk/contract.h"

namespace latchwork::sdk {

/// Receives tuples of ground terms one by one.
class AnswerSink {
 public:
  virtual ~AnswerSink() = default;
  virtual void Answer(std::span<const logic::Term> terms) = 0;
};

/// What an attachment may ask of the reasoner that calls it.
class AttachmentContext {
 public:
  virtual ~AttachmentContext() = default;
  /// Every provable instance of the conjunction of `query` in the current body and latches
  /// ("bagof"), each distinct instance once. Variables are 0 .. variables-1; the sink receives
  /// their values in that order. The reasoner's bound closes the set; when a bound was hit the
  /// decision says so.
  virtual void ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                               AnswerSink& sink) = 0;
};

/// A semantic attachment: a predicate of a body whose truth is computed by C++. Called with ground
/// inputs; gives its outputs through the sink: once when deterministic, never when false, often
/// when enumerating. It must be a function of its inputs, its parameters and what it asks of the
/// context; results may be cached for a cycle. Source: LSA (IJCAI-99), section 5, optimization 1.
/// Thread rule: called by one thread at a time. An exception is contained as a fault of the layer.
class Attachment {
 public:
  enum class Mode : unsigned char { kIn, kOut };
  struct Argument {
    ArgumentSpec spec;
    Mode mode = Mode::kIn;
  };
  struct Signature {
    std::string predicate;
    std::vector<Argument> arguments;
    std::string help;
  };

  virtual ~Attachment() = default;
  virtual const Signature& signature() const = 0;
  /// `inputs`: the values of the kIn arguments in order, ground and of the declared types.
  /// `outputs` receives the values of the kOut arguments in order (an empty tuple when there are
  /// none and the predicate is true).
  virtual void Call(std::span<const logic::Term> inputs, AttachmentContext& context,
                    AnswerSink& outputs) = 0;
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_ATTACHMENT_H_
