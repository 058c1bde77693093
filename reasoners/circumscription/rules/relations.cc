// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/circumscription/rules/relations.h"

#include <algorithm>
#include <utility>

namespace latchwork::circumscription {

std::size_t Relations::Of(const logic::PredicateName& name) {
  const auto [place, is_new] = places_.try_emplace(name, infos_.size());
  if (is_new) infos_.emplace_back().name = name;
  return place->second;
}

std::size_t Relations::Find(const logic::PredicateName& name) const {
  const auto place = places_.find(name);
  return place == places_.end() ? kNoIndex : place->second;
}

void Relations::DeclareAttachment(const logic::PredicateName& name,
                                  std::shared_ptr<sdk::Attachment> code) {
  infos_[Of(name)].attachment = attachments_.size();
  attachments_.push_back(std::move(code));
}

void Relations::Index(std::size_t relation, std::size_t column) {
  std::vector<std::size_t>& columns = infos_[relation].columns;
  if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
    columns.push_back(column);
  }
}

}  // namespace latchwork::circumscription
