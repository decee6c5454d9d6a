#include "x86model/clock_rows.hpp"

#include <algorithm>

namespace x86model::figures {

namespace {

bool has_name(std::string_view names, std::string_view mnemonic) {
  const std::size_t at = names.find(mnemonic);
  return at != std::string_view::npos && at > 0 && names[at - 1] == ' ' &&
         names[at + mnemonic.size()] == ' ';
}

template <class T, std::size_t n>
const T* found_in(const std::array<T, n>& table, std::string_view mnemonic,
                  std::string_view shape) {
  const auto* found = std::find_if(table.begin(), table.end(), [&](const T& row) {
    return has_name(row.names, mnemonic) && row.shape == shape;
  });
  return found == table.end() ? nullptr : found;
}

}  // namespace

std::vector<const Row*> rows_of(std::string_view mnemonic) {
  std::vector<const Row*> found;
  for (const Row& row : rows) {
    if (has_name(row.names, mnemonic)) found.push_back(&row);
  }
  return found;
}

const Row* row_of(std::span<const Row* const> candidates, std::string_view shape, char size) {
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Row* row) {
    return row->shape == shape && row->sizes.find(size) != std::string_view::npos;
  });
  return found == candidates.end() ? nullptr : *found;
}

const Transfer* transfer_of(std::string_view mnemonic, std::string_view shape, bool taken) {
  return taken ? found_in(transfers, mnemonic, shape) : found_in(not_taken, mnemonic, shape);
}

}  // namespace x86model::figures
