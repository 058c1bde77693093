// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/term_copier.h"

#include "reasoners/pttp/terms/calculator.h"

namespace latchwork::pttp {

Word TermCopier::CopyAtomic(Word word, Arena& arena) {
  return IsNumber(word) ? Box(Number::In(word), arena) : word;
}

Word TermCopier::CopyCompound(Word word, Arena& arena) {
  Word* const whole = arena.Allocate(ArityOf(*AddressOf(word)) + 1);
  tasks_.assign(1, {AddressOf(word), whole});
  while (!tasks_.empty()) {
    const Task task = tasks_.back();
    tasks_.pop_back();
    task.to[0] = task.from[0];
    for (std::size_t i = ArityOf(task.from[0]); i > 0; --i) {
      const Word part = Dereference(task.from[i]);
      if (TagOf(part) != Tag::kCompound) {
        task.to[i] = CopyAtomic(part, arena);
        continue;
      }
      Word* const block = arena.Allocate(ArityOf(*AddressOf(part)) + 1);
      tasks_.push_back({AddressOf(part), block});
      task.to[i] = Tagged(Tag::kCompound, block);
    }
  }
  return Tagged(Tag::kCompound, whole);
}

}  // namespace latchwork::pttp
