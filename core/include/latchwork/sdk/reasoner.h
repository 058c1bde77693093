// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_SDK_REASONER_H_
#define LATCHWORK_SDK_REASONER_H_

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "latchwork/logic/atom.h"
#include "latchwork/logic/diagnostic.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "latchwork/sdk/contract.h"
#include "latchwork/sdk/decision.h"
#include "latchwork/sdk/explanation.h"
#include "latchwork/sdk/parameters.h"
#include "latchwork/sdk/undecided.h"

namespace latchwork::sdk {

/// What a layer tries to conclude in each cycle: an atom with variables 0 .. variables-1.
struct Goal {
  enum class Answers : std::uint8_t { kFirst, kAll };
  logic::Atom pattern;
  std::size_t variables = 0;
  Answers answers =
      Answers::kFirst;  ///< kFirst: the first proof in clause order. kAll: every provable instance.
  std::size_t port = 0;  ///< The output port of the contract that its conclusions leave by.
};

/// A predicate closed by circumscription: an instance that cannot be proved is assumed not to hold.
struct Minimized {
  logic::PredicateName predicate;
  std::uint32_t depth = 0;     ///< Bound of the closing proof; 0: the budget's.
  std::uint32_t priority = 1;  ///< Level at which it is minimized; 1 comes first.
};

/// The part of a layer that does not change from cycle to cycle, in the language of some reasoner.
struct Body {
  std::string language;                      ///< "tptp", "icarus", …
  std::vector<std::filesystem::path> files;  ///< In loading order.
  std::vector<logic::Fact> facts;  ///< Parameters of the layer as facts, e.g. halt_distance(0.45).
  std::vector<logic::PredicateName> inputs;  ///< What the latches may hold.
  std::vector<Goal> goals;
  std::vector<Minimized> minimized;
  std::vector<logic::PredicateName> fixed;  ///< Neither minimized nor varied; the rest varies.
  std::vector<std::shared_ptr<Attachment>> attachments;
  Contract contract;  ///< Of its layer: the types that a reasoner may check a body against. May be
                      ///< empty.
};

/// What one input of a layer holds in this cycle.
struct Latch {
  std::string port;
  std::vector<logic::Fact> facts;  ///< The last batch, whole; empty when silent or stale.
  std::uint64_t version =
      0;  ///< Changes exactly when what it holds changes; lets a reasoner keep what is still valid.
  Undecided undecided = {};  ///< What may hold besides `facts`.
};

/// A fact that must not enter a latch, with the hard axiom it offends.
struct Refusal {
  std::size_t index = 0;  ///< Into the batch.
  std::string reason;
};

/// Turns (body, latches, goals, budget) into a decision; a backend.
///
/// Order of calls: Load once and successfully; then Decide, Admit, Tell, Retract and Explain in any
/// order. Thread rule: an object is used by one thread at a time; different objects share nothing
/// but the symbol table. Determinism: with no deadline and no cancellation, Decide is a function of
/// what was loaded and told, the latches and the budget. Exceptions that leave a member are
/// contained by the scheduler and recorded as a fault of the layer.
class Reasoner {
 public:
  virtual ~Reasoner() = default;

  /// The language of the bodies it reads; "" when any will do.
  virtual std::string_view language() const = 0;
  /// Whether Decide looks at undecided latch facts itself. If not, it is called once for each state
  /// that they may be in, with latches that hold decided facts only.
  virtual bool takes_undecided() const { return false; }
  /// Whether a decision depends on earlier ones. Then undecided facts are left out instead: what
  /// may not hold must leave no trace.
  virtual bool keeps_memory() const { return false; }
  virtual std::span<const ParameterSpec> parameters() const = 0;

  /// Reads and compiles the body. On diagnostics nothing is loaded. `symbols` outlives the
  /// reasoner.
  virtual logic::Diagnostics Load(const Body& body, const Parameters& parameters,
                                  logic::SymbolTable& symbols) = 0;

  /// One cycle. `latches` come in the order of the contract's inputs. Overwrites `decision`, whose
  /// memory is reused.
  virtual void Decide(std::span<const Latch> latches, const Budget& budget, Decision& decision) = 0;

  /// Which facts of a batch contradict the hard part of the body (that is, without its defaults)
  /// together with what the latches hold and the facts of the batch before them. Appends to
  /// `refused`, in the order of the batch. `port` is the index of the latch that the batch is meant
  /// for; its present content does not count. A fact whose check runs out of budget is admitted.
  /// Source: layered soundness needs consistency with what is handed down (LSA, section 3.3).
  virtual void Admit(std::span<const Latch> latches, std::size_t port,
                     std::span<const logic::Fact> batch, const Budget& budget,
                     std::vector<Refusal>& refused) = 0;

  /// Adds clauses to the body while the robot runs, or takes away those of a name. Text in the
  /// reasoner's language.
  virtual logic::Diagnostics Tell(std::string_view text) = 0;
  virtual logic::Diagnostics Retract(std::string_view name) = 0;

  /// How a conclusion of the last decision came about; valid until the next Decide. May search
  /// again.
  virtual Derivation Explain(std::size_t conclusion) = 0;
  /// Why an assumption of the last decision was made, or which facts of which latches retracted it.
  /// Valid and allowed as Explain; nothing from a reasoner that keeps no such reasons.
  virtual std::optional<Explanation> ExplainAssumption(std::size_t /*assumption*/) {
    return std::nullopt;
  }
  /// Why no instance of an atom was concluded in the last decision, or how one was.
  virtual std::optional<Explanation> WhyNot(const logic::Atom& /*pattern*/) { return std::nullopt; }
};

}  // namespace latchwork::sdk

#endif  // LATCHWORK_SDK_REASONER_H_
