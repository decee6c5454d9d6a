// The functions that the page calls. A request is text that the page writes into the buffer; an
// answer is text, too.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "web/number.hpp"
#include "web/operate.hpp"
#include "web/trace.hpp"

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): the page reads and writes this
// memory
namespace {

std::array<char, std::size_t{1} << 20U> request_text;
std::string answer_text;

std::string_view request(std::size_t length) {
  return {request_text.data(), std::min(length, request_text.size())};
}
std::size_t answered(std::string answer) {
  answer_text = std::move(answer);
  return answer_text.size();
}

}  // namespace
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

#define FIXPROOF_EXPORT(name) extern "C" __attribute__((export_name(#name)))

/// Where the page writes requests, and how many bytes it may write.
FIXPROOF_EXPORT(request_buffer) char* request_buffer() { return request_text.data(); }
FIXPROOF_EXPORT(request_size) std::size_t request_size() { return request_text.size(); }
/// Where the last answer is. Functions that answer return its length.
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
