// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/exact/derivation.h"

#include <map>
#include <utility>
#include <vector>

namespace latchwork::circumscription {
namespace {

using Kind = sdk::DerivationStep::Kind;
using Key = std::pair<std::uint32_t, std::uint32_t>;

Key KeyOf(FactRef fact) { return {fact.relation, fact.row}; }

class Writer {
 public:
  Writer(const Evaluator& evaluator, std::span<const std::string> ports)
      : evaluator_(evaluator), ports_(ports) {}

  /// The step that concludes `fact`. Derivations are as deep as there are rules on a path.
  std::size_t Write(FactRef fact) {
    const auto place = steps_.find(KeyOf(fact));
    if (place != steps_.end()) return place->second;
    sdk::DerivationStep step;
    if (fact.relation == FactRef::kAssumption) {
      step.kind = Kind::kAssumption;
      const logic::Fact atom = evaluator_.DefaultAtom(evaluator_.defaults()[fact.row]);
      step.conclusion = ToString(logic::Literal{false, atom});
      step.source = atom.predicate().name();
    } else {
      const FactInfo& info = evaluator_.InfoOf(fact);
      step.conclusion = ToString(evaluator_.FactOf(fact));
      for (const FactRef premise : evaluator_.Premises(info)) {
        step.premises.push_back(Write(premise));
      }
      Describe(fact, info, step);
    }
    derivation.steps.push_back(std::move(step));
    return steps_[KeyOf(fact)] = derivation.steps.size() - 1;
  }
  sdk::Derivation derivation;

 private:
  void Describe(FactRef fact, const FactInfo& info, sdk::DerivationStep& step) const {
    switch (info.origin) {
      case FactInfo::Origin::kLatch:
        step.kind = Kind::kLatch;
        step.source = ports_[info.source];
        break;
      case FactInfo::Origin::kAttachment:
        step.kind = Kind::kAttachment;
        step.source = evaluator_.program().relations()[fact.relation].name.symbol.name();
        break;
      case FactInfo::Origin::kRule: {
        const logic::Clause& clause = evaluator_.program().clauses()[info.source];
        step.source = clause.name;
        step.place = clause.place;
        break;
      }
      case FactInfo::Origin::kBody:
        step.source = "body";
    }
  }

  const Evaluator& evaluator_;
  std::span<const std::string> ports_;
  std::map<Key, std::size_t> steps_;
};

}  // namespace

sdk::Derivation DeriveFact(const Evaluator& evaluator, FactRef fact,
                           std::span<const std::string> ports) {
  Writer writer(evaluator, ports);
  writer.Write(fact);
  return std::move(writer.derivation);
}

}  // namespace latchwork::circumscription
