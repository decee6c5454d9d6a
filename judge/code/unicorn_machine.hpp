/// @file
/// What the machines on Unicorn share: memory, limits, ends and traces of calls.
#pragma once

#include "judge/code/machine.hpp"
#include "judge/code/unicorn_engine.hpp"

namespace fixproof::judge {

class UnicornMachine : public Machine {
 public:
  [[nodiscard]] std::uint8_t* memory() const override { return memory_.bytes(); }

 protected:
  /// Maps the image's memory.
  /// @param trace receives every step of the calls; null for speed
  /// @param model the processor's number in Unicorn; -1 for its default
  /// @throws machine_code::EmulatorError
  UnicornMachine(const Image& image, Trace* trace, uc_arch processor, uc_mode mode, int model = -1);

  /// Returns the registers in the middle of a call.
  [[nodiscard]] virtual Registers current() = 0;
  /// Returns how an exception of the processor ends a call.
  [[nodiscard]] virtual End end_after_exception(std::uint32_t number) = 0;

  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] uc_engine* engine() const { return engine_.get(); }
  [[nodiscard]] Engine& owner() { return engine_; }
  [[nodiscard]] const Trace* trace() const { return trace_; }
  [[nodiscard]] std::size_t bytes_of_memory() const { return memory_.size(); }
  [[nodiscard]] std::uint64_t read(int number) const;
  void write(int number, std::uint64_t value) const;

  /// Adds what watches every call, after the constructors.
  void add_hooks();
  /// Runs a call.
  /// @param until the address where it ends; none if a hook ends it
  uc_err run(std::uint64_t from, std::uint64_t until);
  /// How the call ended so far; halted if nothing has stopped it.
  [[nodiscard]] Ending& ending() { return ending_; }
  void stop(End end);
  /// Returns the place of the last step of a trace, which is exact, or else `otherwise`.
  [[nodiscard]] std::uint32_t last_place(std::uint32_t otherwise) const;

  /// This object, for hooks.
  [[nodiscard]] void* as_data() { return this; }
  template <class T = UnicornMachine>
  static T& self(void* data) {
    return *static_cast<T*>(static_cast<UnicornMachine*>(data));
  }

 private:
  void add_trace_hooks();
  void note_access(uc_mem_type type, std::uint64_t address, int size);

  const Image& image_;
  Trace* trace_;
  MappedMemory memory_;
  Engine engine_;
  Ending ending_;
  std::uint64_t blocks_ = 0;
};

}  // namespace fixproof::judge
