// SPDX-License-Identifier: BSD-3-Clause
#include "apps/latchwork_mpi/mpi_link.h"

#include <mpi.h>

#include <chrono>
#include <cstddef>
#include <list>
#include <thread>
#include <utility>

namespace latchwork::mpi {
namespace {

using namespace std::chrono_literals;

constexpr int kTag = 1;

struct Transfer {
  Message message;  ///< Must stay where it is until the transfer is over.
  MPI_Request request = MPI_REQUEST_NULL;
};

/// A transfer that failed is over as well: the other side is dead.
bool IsOver(Transfer& transfer) {
  int over = 0;
  return MPI_Test(&transfer.request, &over, MPI_STATUS_IGNORE) != MPI_SUCCESS || over != 0;
}

}  // namespace

struct MpiLink::Transfers {
  std::list<Transfer> sending;
  std::list<Transfer> receiving;
};

MpiLink::MpiLink(int& argc, char**& argv) : transfers_(std::make_unique<Transfers>()) {
  int level = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

MpiLink::~MpiLink() = default;

void MpiLink::Send(int to, std::string text) {
  Transfer& transfer = transfers_->sending.emplace_back();
  transfer.message = {to, std::move(text)};
  const std::string& kept = transfer.message.text;
  MPI_Isend(kept.data(), static_cast<int>(kept.size()), MPI_CHAR, to, kTag, MPI_COMM_WORLD,
            &transfer.request);
  sent_all();
}

bool MpiLink::sent_all() {
  transfers_->sending.remove_if(IsOver);
  return transfers_->sending.empty();
}

void MpiLink::Flush() {
  const auto end = std::chrono::steady_clock::now() + 2s;
  while (!sent_all() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(500us);
}

std::optional<Message> MpiLink::Receive() {
  int found = 0;
  MPI_Message incoming = MPI_MESSAGE_NULL;
  MPI_Status status{};
  if (MPI_Improbe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &found, &incoming, &status) ==
          MPI_SUCCESS &&
      found != 0) {
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    Transfer& transfer = transfers_->receiving.emplace_back();
    transfer.message = {status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Imrecv(transfer.message.text.data(), size, MPI_CHAR, &incoming, &transfer.request);
  }
  for (auto each = transfers_->receiving.begin(); each != transfers_->receiving.end(); ++each) {
    if (!IsOver(*each)) continue;
    Message message = std::move(each->message);
    transfers_->receiving.erase(each);
    return message;
  }
  return std::nullopt;
}

void MpiLink::Part() { MPI_Finalize(); }

}  // namespace latchwork::mpi
