// Cutter radius compensation: programmed moves in, the moves of the tool's centre out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/compensation/held_move.hpp"
#include "parser/compensation/path_sender.hpp"
#include "parser/modal/end_point.hpp"

namespace kerf::parser {

enum class CutterSide : std::uint8_t { left, right };  // of the contour, seen along its travel

struct CompensationStart {
  CutterSide side = CutterSide::left;
  double radius_mm = 0.0;   // >= 0
  Plane plane = Plane::xy;  // xy or zx
  // Of a turning tool's tip in the plane zx, 0 to 9 as in LinuxCNC's tool table: where the
  // controlled point lies from the centre of the tip's circle. 0 and 9, and every mill: there.
  int orientation = 0;
};

// Between start() and the first move after stop() every move goes through take(), in the order of
// the program and in machine coordinates; ready() holds what the machine is to do instead.
//
// The first move in the plane is the entry, a line to the point beside its programmed end; the
// first line after stop() is the exit, straight to its programmed end. Between them the centre
// keeps the radius from the contour: about outside corners on an arc of that radius, which has the
// source and the feedrate of the move after the corner; from inside corners it stays away. Lines
// along the plane's normal, dwells and events stay where the program has them.
//
// A move is held until the corner at its end is known and kWindow further moves in the plane are,
// so that the tool's way past one is compared with the contour of all of them: what it would cut
// into is an error before it moves. Moves at another depth (no common range along the normal) and
// rapids have no contour to keep away from, and a rapid ends what is compared.
//
// faults() gives what is wrong at the move to blame, when that move is sent. After an error the
// corner or the move is left out, and what follows is still checked.
class CutterCompensation {
 public:
  static constexpr std::size_t kWindow = 8;
  static constexpr std::size_t kMaxHeld = 1000;  // moves, those without motion in the plane too

  // Precondition: not on().
  void start(const CompensationStart& start);
  void stop();
  // The program ends at `place`: sends all that is held and is off.
  void finish(const diagnostics::DiagnosticPlace& place);

  // From start() to stop().
  [[nodiscard]] bool on() const { return on_; }
  [[nodiscard]] ContourPhase phase() const {
    return on_ ? ContourPhase::held : leaving_ ? ContourPhase::leaving : ContourPhase::none;
  }
  // The next line is the exit, even if its programmed length is 0.
  [[nodiscard]] bool leaving() const { return leaving_; }
  [[nodiscard]] double radius_mm() const { return start_.radius_mm; }
  // Moves must go through take().
  [[nodiscard]] bool busy() const { return on_ || leaving_; }

  // `place` is that of the move.
  void take(const Move& move, diagnostics::DiagnosticPlace place);
  // What is wrong with the moves sent since the last call, in their order.
  std::vector<ContourFault> faults() { return std::exchange(faults_, {}); }
  // Drops the faults of the moves held, since another error has spoilt the contour.
  void forget_faults();
  [[nodiscard]] MoveQueue& ready() { return sender_.sent(); }

 private:
  struct Cut {
    HeldMove* mover;
    HeldMove* contour;
    double depth_mm;

    [[nodiscard]] bool is_error() const;
  };

  struct Meeting {
    bool returns = false;           // it begins on the contour: a contour has closed
    std::uint64_t leads_up_to = 0;  // the moves up to this number lead to the contour
  };

  // In force, and placed.
  void take_compensated(const Move& move);
  void take_entry(const Move& move);
  void take_contour(const Move& move);
  void take_exit(const Move& move);
  void hold_idle(const Move& move);
  HeldMove& hold(const Move& move, HeldRole role);
  [[nodiscard]] bool goes_on_at(const Point& start_mm);
  [[nodiscard]] HeldMove* last_curve();
  void join(HeldMove& first, HeldMove& second);
  void join_inside(HeldMove& first, HeldMove& second, const OffsetCorner& corner);
  bool has_room(HeldMove& held);
  [[nodiscard]] bool is_first(const HeldMove& move) const;
  static void cut_off_overrun(const HeldMove& first, HeldMove& newest);
  Meeting meeting_of(HeldMove& newest);
  void find_leads(HeldMove& newest);
  void settle(HeldMove& move);
  void settle_last();
  [[nodiscard]] std::vector<Cut> cuts_of(HeldMove& mover);
  void report(std::vector<Cut> cuts);
  void report_cut(const Cut& cut);
  void send_surplus();
  void send_all();
  void send(const HeldMove& held);
  void blame(HeldMove& held, const diagnostics::ErrorPage& page, std::string message);

  [[nodiscard]] planar::ContourElement curve_of(const Move& move) const;
  [[nodiscard]] bool moves_in_plane(const Move& move) const;
  [[nodiscard]] double left_mm() const {
    return start_.side == CutterSide::left ? start_.radius_mm : -start_.radius_mm;
  }

  PathSender sender_;
  std::vector<ContourFault> faults_;
  diagnostics::DiagnosticPlace place_;  // of the move that is being taken
  CompensationStart start_;
  bool on_ = false;
  bool leaving_ = false;
  bool displaced_ = false;  // started right after a G40: the tool was still beside a contour
  bool placed_ = false;     // the sender knows where the machine is
  bool entered_ = false;    // the entry was taken
  std::deque<HeldMove> held_;
  std::size_t curves_ = 0;  // in held_, without the idle ones
  std::uint64_t number_ = 0;
  int leads_left_ = 0;  // moves after the place where a contour has closed
  std::uint32_t run_ = 1;
};

}  // namespace kerf::parser
