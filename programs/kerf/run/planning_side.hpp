// What takes a program's text and plans it: a kernel, or the controller that runs one.
#pragma once

#include <string_view>

#include <kerf/controller.hpp>
#include <kerf/kernel.hpp>

namespace kerf::program {

class PlanningSide {
 public:
  PlanningSide() = default;
  virtual ~PlanningSide() = default;
  PlanningSide(const PlanningSide&) = delete;
  PlanningSide& operator=(const PlanningSide&) = delete;

  virtual void feed(std::string_view text) = 0;
  virtual void finish() = 0;
  // True: more text is wanted.
  virtual bool plan() = 0;
  virtual void text_is_late() = 0;
  virtual void stop() = 0;
  [[nodiscard]] virtual const Kernel& kernel() const = 0;
};

class KernelPlanning final : public PlanningSide {
 public:
  explicit KernelPlanning(Kernel& kernel) noexcept : kernel_(&kernel) {}

  void feed(std::string_view text) override { kernel_->feed(text); }
  void finish() override { kernel_->finish(); }
  bool plan() override { return kernel_->plan(); }
  void text_is_late() override {
    if (kernel_->runs_low()) {
      kernel_->plan_to_rest();
    }
  }
  void stop() override { kernel_->stop(); }
  [[nodiscard]] const Kernel& kernel() const override { return *kernel_; }

 private:
  Kernel* kernel_;
};

// Precondition of feed(), finish() and kernel(): a program was started.
class ControllerPlanning final : public PlanningSide {
 public:
  explicit ControllerPlanning(Controller& controller) noexcept : controller_(&controller) {}

  void feed(std::string_view text) override { controller_->feed(text); }
  void finish() override { controller_->finish(); }
  bool plan() override {
    const bool wants_text = controller_->plan();
    if (stops_ && controller_->status().state == ControllerState::held) {
      stop();  // it was jogged away from there
    }
    return wants_text;
  }
  void text_is_late() override { controller_->text_is_late(); }
  // Refused once the program is over. A jog is stopped first.
  void stop() override {
    stops_ = true;
    static_cast<void>(controller_->give(kerf::Command::stop));
  }
  [[nodiscard]] const Kernel& kernel() const override { return *controller_->program(); }

 private:
  Controller* controller_;
  bool stops_ = false;
};

}  // namespace kerf::program
