// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_MPI_MPI_LINK_H_
#define LATCHWORK_APPS_LATCHWORK_MPI_MPI_LINK_H_

#include <memory>
#include <optional>
#include <string>

namespace latchwork::mpi {

struct Message {
  int from = 0;
  std::string text;
};

/// Texts between the processes that mpirun started. Nothing here waits for another process, which
/// may be dead, but Part(), and for a short time Flush(). Thread rule: the thread that made it; one
/// per process.
class MpiLink {
 public:
  MpiLink(int& argc, char**& argv);
  MpiLink(const MpiLink&) = delete;
  MpiLink& operator=(const MpiLink&) = delete;
  ~MpiLink();

  int rank() const { return rank_; }
  int size() const { return size_; }

  void Send(int to, std::string text);
  /// The next text that has arrived whole.
  std::optional<Message> Receive();
  /// Lets everything sent leave this process, but waits for two seconds at most.
  void Flush();

  /// Ends the use of MPI, together with all other processes.
  void Part();

 private:
  struct Transfers;
  /// Whether everything sent has left this process.
  bool sent_all();
  std::unique_ptr<Transfers> transfers_;
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace latchwork::mpi

#endif  // LATCHWORK_APPS_LATCHWORK_MPI_MPI_LINK_H_
