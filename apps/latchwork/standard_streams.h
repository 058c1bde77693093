// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_APPS_LATCHWORK_STANDARD_STREAMS_H_
#define LATCHWORK_APPS_LATCHWORK_STANDARD_STREAMS_H_

namespace latchwork::app {

/// Where standard input, output or error came closed, no file that is opened later takes its place:
/// using the stream fails instead.
void ReserveStandardStreams();

/// Whether standard output took all that was printed; if not, says so on standard error. A full
/// disk must not look like success.
bool OutputIsWhole();

}  // namespace latchwork::app

#endif  // LATCHWORK_APPS_LATCHWORK_STANDARD_STREAMS_H_
