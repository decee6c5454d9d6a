// The functions that the page calls. The page writes a request as text into the buffer, and the
// answer is text, too.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "app/web/number.hpp"
#include "app/web/operate.hpp"
#include "app/web/stage.hpp"
#include "app/web/trace.hpp"

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): memory that the page uses
namespace {

std::array<char, std::size_t{1} << 20U> request_text;
std::string answer_text;
std::unique_ptr<fixproof::web::Stage> stage;

std::string_view request(std::size_t length) {
  return {request_text.data(), std::min(length, request_text.size())};
}
std::size_t answered(std::string answer) {
  answer_text = std::move(answer);
  return answer_text.size();
}

}  // namespace
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): an attribute needs the name as a literal
#define FIXPROOF_EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Where the page writes requests, and the size of that buffer in bytes.
FIXPROOF_EXPORT(request_buffer) char* request_buffer() { return request_text.data(); }
FIXPROOF_EXPORT(request_size) std::size_t request_size() { return request_text.size(); }
/// Where the last answer is. The functions below that answer return its length.
FIXPROOF_EXPORT(answer_buffer) const char* answer_buffer() { return answer_text.data(); }

FIXPROOF_EXPORT(number) std::size_t number(std::size_t length) {
  return answered(fixproof::web::number_view(request(length)));
}
FIXPROOF_EXPORT(operation) std::size_t operation(std::size_t length) {
  return answered(fixproof::web::operation_view(request(length)));
}
FIXPROOF_EXPORT(answers) std::size_t answers(std::size_t length) {
  return answered(fixproof::web::answers(request(length)));
}
FIXPROOF_EXPORT(routines) std::size_t routines() { return answered(fixproof::web::routines()); }
FIXPROOF_EXPORT(trace) std::size_t trace(std::size_t length) {
  return answered(fixproof::web::trace(request(length)));
}
FIXPROOF_EXPORT(state) std::size_t state(std::size_t length) {
  return answered(fixproof::web::state(request(length)));
}
FIXPROOF_EXPORT(stages) std::size_t stages() { return answered(fixproof::web::stages()); }

// The stage. Call stage_open() before the other functions.
FIXPROOF_EXPORT(stage_open)
void stage_open(std::size_t scene, std::size_t played, std::size_t compared) {
  stage = std::make_unique<fixproof::web::Stage>(scene, std::array{played, compared});
}
FIXPROOF_EXPORT(stage_switch) void stage_switch(std::size_t arithmetic) {
  stage->switch_arithmetic(arithmetic);
}
FIXPROOF_EXPORT(stage_seek) std::uint32_t stage_seek(std::uint32_t frame, std::uint32_t moves) {
  return stage->seek(frame, moves);
}
FIXPROOF_EXPORT(stage_draw) std::uint32_t stage_draw() { return stage->draw(); }
/// Returns the last drawing: 0 and 1 are the sides, 2 is their differences.
FIXPROOF_EXPORT(stage_pixels) const std::uint8_t* stage_pixels(std::size_t which) {
  using fixproof::web::Stage;
  return (which == 2 ? stage->differences()
                     : stage->pixels(which == 0 ? Stage::played : Stage::compared))
      .data();
}
FIXPROOF_EXPORT(stage_indices) const std::uint8_t* stage_indices() {
  return stage->indices(fixproof::web::Stage::played).data();
}
