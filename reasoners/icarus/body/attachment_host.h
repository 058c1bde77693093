// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_ICARUS_ATTACHMENT_HOST_H_
#define LATCHWORK_ICARUS_ATTACHMENT_HOST_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latchwork/sdk/reasoner.h"
#include "reasoners/icarus/body/term_bridge.h"
#include "reasoners/icarus/machine/host.h"
#include "reasoners/icarus/machine/interpreter.h"

namespace latchwork::icarus {

/// The functions of a layer's program: its attachments to be called, the predicates of its outputs
/// to be acts. The facts of its inputs and parameters are those that memory may hold.
class AttachmentHost final : public Host, private sdk::AttachmentContext {
 public:
  AttachmentHost(const sdk::Body& body, TermBridge& bridge);
  AttachmentHost(const AttachmentHost&) = delete;
  AttachmentHost& operator=(const AttachmentHost&) = delete;
  ~AttachmentHost() override = default;

  std::span<const Signature> functions() const override { return functions_; }
  std::optional<std::span<const Signature>> acts() const override { return acts_; }
  std::span<const Signature> facts() const override { return facts_; }
  Value Call(std::size_t function, std::span<const Value> arguments, Arena& arena,
             NamePool& names) override;

  /// Who answers what attachments ask, and the program by whose skills.
  void Serve(Interpreter& interpreter, const Program& program);
  void ResetCalls() { calls_ = 0; }
  std::uint64_t calls() const { return calls_; }

 private:
  struct Query {
    std::vector<logic::Literal> literals;
    std::size_t number = 0;  ///< Of the interpreter.
  };
  class Answers;
  class Environments;

  void ForEachProvable(std::span<const logic::Literal> query, std::size_t variables,
                       sdk::AnswerSink& sink) override;
  std::size_t QueryNumber(std::span<const logic::Literal> query, std::size_t variables);
  Clause ClauseOf(const logic::Literal& literal) const;
  Signature Declare(std::string_view name, std::vector<ArgumentType> types);
  std::vector<logic::Term>& Terms();

  const sdk::Body& body_;
  TermBridge& bridge_;
  Interpreter* interpreter_ = nullptr;
  const Program* program_ = nullptr;
  std::deque<std::string> texts_;
  std::deque<std::vector<ArgumentType>> types_;
  std::vector<Signature> functions_;
  std::vector<Signature> acts_;
  std::vector<Signature> facts_;
  std::vector<Query> queries_;
  std::deque<std::vector<logic::Term>> terms_;  ///< Used by calls within calls.
  std::size_t terms_used_ = 0;
  std::uint64_t calls_ = 0;
};

}  // namespace latchwork::icarus

#endif  // LATCHWORK_ICARUS_ATTACHMENT_HOST_H_
