// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SWIPL_CONVERSATION_H_
#define LATCHWORK_SWIPL_CONVERSATION_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/process/companion.h"
#include "latchwork/sdk/attachment.h"
#include "reasoners/swipl/answer_reader.h"
#include "reasoners/swipl/names.h"
#include "reasoners/swipl/rule_writer.h"

namespace latchwork::swipl {

/// What Prolog says in the course of one command, besides what attachments are asked for.
class Listener {
 public:
  virtual ~Listener() = default;
  virtual void Hear(const Answer& said) = 0;
};

/// One command and all that is said until it is done: Prolog calls attachments, and these ask
/// Prolog.
class Conversation final : public sdk::AttachmentContext {
 public:
  using Patience = process::Companion::Patience;
  enum class End { kDone, kLate, kCancelled, kGone, kMisunderstood };
  struct Setting {
    process::Companion& companion;
    Names& names;
    RuleWriter& writer;
    std::span<const std::shared_ptr<sdk::Attachment>> attachments;
    std::uint32_t depth;
    Patience patience;
  };

  Conversation(const Setting& setting, Listener& listener)
      : setting_(setting), listener_(listener) {}

  End Hold(std::string_view command);
  std::size_t attachment_calls() const { return attachment_calls_; }
  /// What was not understood.
  const std::string& line() const { return line_; }

  void ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                       sdk::AnswerSink& sink) override;

 private:
  class Outputs;

  void Say(std::string_view text);
  /// Listens up to a line of this name, or the end of the command.
  void ListenFor(std::string_view last);
  void Call(const Answer& call);
  void Take(const Answer& answer);
  void Stop(End end);

  Setting setting_;
  Listener& listener_;
  std::string line_;
  std::vector<std::vector<logic::Term>>* answers_ = nullptr;  ///< Of the question at hand.
  std::int64_t call_ = 0;  ///< Prolog's number of the call at hand.
  std::size_t attachment_calls_ = 0;
  bool is_over_ = false;
  End end_ = End::kDone;
};

}  // namespace latchwork::swipl

#endif  // LATCHWORK_SWIPL_CONVERSATION_H_
