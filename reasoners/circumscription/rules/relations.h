// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RELATIONS_H_
#define LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RELATIONS_H_

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "latchwork/sdk/attachment.h"
#include "reasoners/circumscription/rules/rule.h"

namespace latchwork::circumscription {

/// The predicates and attachments that rules speak of, numbered.
class Relations {
 public:
  /// Added where it is new.
  std::size_t Of(const logic::PredicateName& name);
  /// kNoIndex: nobody speaks of it.
  std::size_t Find(const logic::PredicateName& name) const;
  void DeclareAttachment(const logic::PredicateName& name, std::shared_ptr<sdk::Attachment> code);
  /// That `column` of `relation` is looked up.
  void Index(std::size_t relation, std::size_t column);

  std::size_t size() const { return infos_.size(); }
  RelationInfo& operator[](std::size_t relation) { return infos_[relation]; }
  const RelationInfo& operator[](std::size_t relation) const { return infos_[relation]; }
  sdk::Attachment& attachment(std::size_t index) const { return *attachments_[index]; }
  bool IsAttachment(std::size_t relation) const { return infos_[relation].attachment != kNoIndex; }

 private:
  std::vector<RelationInfo> infos_;
  std::map<logic::PredicateName, std::size_t> places_;
  std::vector<std::shared_ptr<sdk::Attachment>> attachments_;
};

}  // namespace latchwork::circumscription

#endif  // LATCHWORK_REASONERS_CIRCUMSCRIPTION_RULES_RELATIONS_H_
