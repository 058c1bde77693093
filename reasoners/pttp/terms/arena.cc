// SPDX-License-Identifier: BSD-3-Clause
#include "reasoners/pttp/terms/arena.h"

#include <algorithm>

namespace latchwork::pttp {

Word* Arena::AllocateInNextChunk(std::size_t words) {
  const std::size_t next = chunks_.empty() ? 0 : chunk_ + 1;
  if (next >= chunks_.size() || chunks_[next].size() <= words) {
    const std::size_t doubled = kFirstChunk << std::min<std::size_t>(next, 8);
    const std::size_t size = std::max(words + 1, std::min(doubled, kLargestChunk));
    chunks_.emplace(chunks_.begin() + static_cast<std::ptrdiff_t>(next), size);
    reserved_ += size;
  }
  chunk_ = next;
  std::vector<Word>& chunk = chunks_[next];
  top_ = chunk.data() + words;
  limit_ = chunk.data() + chunk.size();
  return chunk.data();
}

void Arena::ReleaseChunks(Mark mark) {
  chunk_ = mark.chunk;
  if (chunks_.empty()) return;
  std::vector<Word>& chunk = chunks_[chunk_];
  top_ = mark.top != nullptr ? mark.top : chunk.data();
  limit_ = chunk.data() + chunk.size();
}

}  // namespace latchwork::pttp
