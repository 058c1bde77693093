// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAMS_H_
#define LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAMS_H_

#include <string_view>

namespace latchwork::icarus::testing {

/// The paper's table 1, with the skills that it leaves out.
inline constexpr std::string_view kCollide = R"((constant *Hard* 100)
(constant *OneCarLength* 1.0)

(CollideWithCar (?car)
  :objective ({InContactWithCar ?car})
  :requires  ((Face ?car) (Near ?car))
  :means     ((Accelerate *Hard*)))

(Accelerate (?n) :action ({SetPedal ?n}))

(Face (?car)
  :objective ({Facing ?car})
  :means     ((Turn)))

(Near (?car)
  :objective ((Distance ?car ?d) {< ?d *OneCarLength*})
  :means     ((GoForward)))

(Distance (?car ?d) :sensor ((bind ?d {range-to ?car})))
(Turn () :action ({turn}))
(GoForward () :action ({goforward}))
)";

/// The paper's table 8: a recursion that swaps its arguments until they are in order.
inline constexpr std::string_view kFastest = R"((MoveToFastestLane ()
  :requires ((CarAhead left ?car1 ?speed1)
             (CarAhead center ?car2 ?speed2)
             (CarAhead right ?car3 ?speed3)
             ;; bubble sort the three cars by speed
             (Fastest ?car1 ?speed1 ?car2 ?speed2 ?c ?s)
             (Fastest ?c ?s ?car3 ?speed3 ?fastest-car ?))
  :means    ((MoveBehind ?fastest-car)))

(CarAhead (?lane ?car ?speed) :sensor ((bind ?car {car-ahead ?lane}) (bind ?speed {speed-of ?car})))

(Fastest (?c1 ?s1 ?c2 ?s2 ?Car ?Speed)
  :objective ({>= ?s1 ?s2} (bind ?Car ?c1) (bind ?Speed ?s1))
  :means     ((Fastest ?c2 ?s2 ?c1 ?s1 ?Car ?Speed)))

(MoveBehind (?car) :action ({behind ?car}))
)";

}  // namespace latchwork::icarus::testing

#endif  // LATCHWORK_TESTS_REASONERS_ICARUS_PROGRAMS_H_
