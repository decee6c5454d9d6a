/// @file
/// The timed operations, their contenders and their operands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/accuracy/subjects.hpp"
#include "measure/host/host_loop.hpp"
#include "measure/host/host_rules.hpp"

namespace fixproof::measure {

enum class HostKind { type, plain, library, floating };

struct HostContender {
  std::string name;   ///< a preset of the type, `idiom`, a library or a language type
  std::string alike;  ///< presets with the same code; may be empty
  HostKind kind;
  std::string rounding;  ///< as documented by its author
  HostJudgement (*judge)(const HostCase& c);
  std::shared_ptr<HostLoop> loop;
};

/// `to nearest, halves up`
std::string rounding_text(oracle::Rounding rounding);

template <class N, class Operation>
HostContender array_contender(std::string name, std::string alike, HostKind kind,
                              std::string rounding, HostJudgement (*judge)(const HostCase&)) {
  return {name, alike, kind, rounding, judge, std::make_shared<ArrayLoop<Operation, N>>()};
}

/// A contender for multiplies with rounding R.
template <class N, oracle::Rounding R>
HostContender product_contender(std::string name, std::string alike, HostKind kind) {
  return array_contender<N, HostProduct>(name, alike, kind, rounding_text(R), product_rounded<R>);
}
/// A contender for vertices whose products have rounding R.
template <class N, oracle::Rounding R>
HostContender vertex_contender(std::string name, std::string alike, HostKind kind) {
  return {name,
          alike,
          kind,
          rounding_text(R),
          coordinate_rounded<R>,
          std::make_shared<VertexLoop<N>>()};
}

/// Operands for which every contender has a result. A block of cases and its results fit in the L1
/// cache. Only the first block is timed.
struct HostOperands {
  std::size_t block = 0;  ///< words per block
  std::vector<std::uint32_t> words;
  std::uint32_t start = 0;           ///< of the chain
  std::vector<std::uint32_t> taken;  ///< the operand of each chain step; empty if there is no chain
};

struct HostOperation {
  std::string name;
  std::string operands_are;
  std::string chain_is{};   ///< empty if there is no chain
  std::size_t words = 1;    ///< words per case
  std::size_t results = 1;  ///< results per case
  std::function<ExactResult(CaseWords in, std::size_t result)> exact{};
  HostOperands operands{};
  std::vector<HostContender> contenders{};
};

/// Cases per block: three arrays of as many doubles take 24 KB.
inline constexpr std::size_t host_block = 1024;
/// Vertices per block, with three numbers each.
inline constexpr std::size_t host_vertices = 512;

HostOperands product_operands(std::uint64_t seed, std::size_t blocks);
HostOperands quotient_operands(std::uint64_t seed, std::size_t blocks);
HostOperands root_operands(std::uint64_t seed, std::size_t blocks);
HostOperands cosine_operands(std::uint64_t seed, std::size_t blocks);
HostOperands vertex_operands(std::uint64_t seed, std::size_t blocks);

/// mul, div, sqrt and cos, then vertex.
std::vector<HostOperation> host_operations(std::uint64_t seed, std::size_t blocks);

/// A library's contenders for a named operation; empty if the library lacks it or is not built in.
std::vector<HostContender> libfixmath_contenders(const std::string& operation);
std::vector<HostContender> freetype_contenders(const std::string& operation);

}  // namespace fixproof::measure
