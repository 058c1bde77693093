// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_CLEANER_ROW_AFTER_H_
#define LATCHWORK_PLUGINS_CLEANER_ROW_AFTER_H_

#include <span>
#include <vector>

#include "latchwork/logic/clause.h"
#include "latchwork/logic/symbol.h"
#include "latchwork/sdk/attachment.h"
#include "plugins/cleaner/remembered_floor.h"

namespace latchwork::cleaner {

/// row_after(J, Clean, Dirty): what memory holds of row J, with the tiles in view as they are seen
/// now; each `none` or runs(First, Last, ...). A tile that is seen to be blocked is in neither.
class RowAfter final : public sdk::Attachment {
 public:
  explicit RowAfter(logic::SymbolTable& symbols);

  const Signature& signature() const override;
  void Call(std::span<const logic::Term> inputs, sdk::AttachmentContext& context,
            sdk::AnswerSink& outputs) override;

 private:
  void Recall(sdk::AttachmentContext& context, std::span<const logic::Literal> query,
              const logic::Term& row, Memory memory);
  void Look(sdk::AttachmentContext& context, const logic::Term& row);
  logic::Term RunsOf(Memory memory) const;

  logic::Symbol dirty_;
  logic::Symbol clean_;
  logic::Symbol runs_;
  logic::Symbol none_;
  std::vector<logic::Literal> clean_query_;
  std::vector<logic::Literal> dirty_query_;
  std::vector<logic::Literal> tile_query_;
  std::vector<logic::Term> answers_;
  std::vector<Memory> tiles_;
};

}  // namespace latchwork::cleaner

#endif  // LATCHWORK_PLUGINS_CLEANER_ROW_AFTER_H_
