#include "x86model/originals.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace x86model {

namespace {

/// A routine of the author's FIXED.ASM under one setting of the switch that affects it.
struct Original {
  Routine routine;
  Target target;
  /// Whether FixedDiv rounds divides, or the others multiplies; CosSin has no switch.
  bool rounding;
  Digest digest;
};

constexpr std::array originals{
    Original{Routine::mul,
             Target::i386,
             true,
             {9, "3713cdcf6f7c0b06873a2fefe0c65b83e6611d5678414a2a0318476d80011023"}},
    Original{Routine::mul,
             Target::i386,
             false,
             {7, "314012e5d58ace73f3921df067dd68871136f09e44eb725fcf33dc712b67de8e"}},
    Original{Routine::mul,
             Target::i8088,
             true,
             {50, "a243d4dfb76039377f64ecff72703277a60f96467782a6f6c4316196a896af99"}},
    Original{Routine::mul,
             Target::i8088,
             false,
             {49, "9c47b496c236fb40c976e7e4b51b2836046487caa074eed02cdfeb4c8e3f2d8a"}},
    Original{Routine::div,
             Target::i386,
             true,
             {29, "b54df775097e980339366294cc1a9365398e170ad1ddd9634cd77a368bfcf6ba"}},
    Original{Routine::div,
             Target::i386,
             false,
             {10, "f60a497498be96d6a7d4075a9b3248880e10969a2c110c2742cb54a5c4f8a266"}},
    Original{Routine::div,
             Target::i8088,
             true,
             {38, "d7e871bb696cc0dfb39ec7d2d16e7d48a0ce5d8dfccbbfd456f17609d0ba1892"}},
    Original{Routine::div,
             Target::i8088,
             false,
             {32, "480e1206c81b88eafdebbc988d0683f1d184494cb261159ad38472dce6d6e0de"}},
    Original{Routine::cossin,
             Target::i386,
             true,
             {52, "f4662e2f90b4a382bdc58ca5b7ec5149b2f9d613e901e61884d10a54997f8d63"}},
    Original{Routine::cossin,
             Target::i8088,
             true,
             {72, "73e3cabcad47252fd65ae28d64ca4a92e8c80986ca0178501f90b6d3d563dc66"}},
    Original{Routine::xformvec,
             Target::i386,
             true,
             {71, "c073aa231533f762499ca5d7597e2e5682abb0471e8e261f5b17521c363fe477"}},
    Original{Routine::xformvec,
             Target::i386,
             false,
             {53, "4233e7fe1bd23502b14a847c2f701af35abe16dc1743f097dc71e6aaa221dfe0"}},
    Original{Routine::xformvec,
             Target::i8088,
             true,
             {115, "57fdd604e306cd41f8c95a9e66c4e007d05e17f81d65a0509c8eab37c7f4e28d"}},
    Original{Routine::xformvec,
             Target::i8088,
             false,
             {115, "57fdd604e306cd41f8c95a9e66c4e007d05e17f81d65a0509c8eab37c7f4e28d"}},
    Original{Routine::concat,
             Target::i386,
             true,
             {242, "0165c19ceeaa7dbe5dd0ffcd38f2a74d6ad17c6dc0433961781b4535181b66ae"}},
    Original{Routine::concat,
             Target::i386,
             false,
             {170, "14f247aa75c66e4afef74420b110bc610dac4ea3aa04a6934116910ff2dd6622"}},
    Original{Routine::concat,
             Target::i8088,
             true,
             {403, "0c76e090ade4632ad2d6a9813d916bce3c39a4fd8221d30c28a0d5467c4e1ba7"}},
    Original{Routine::concat,
             Target::i8088,
             false,
             {403, "0c76e090ade4632ad2d6a9813d916bce3c39a4fd8221d30c28a0d5467c4e1ba7"}},
};

bool rounds(Routine routine, const Build& build) {
  if (routine == Routine::cossin) return true;
  return routine == Routine::div ? build.div_rounding : build.mul_rounding;
}

Digest original(Routine routine, Target target, const Build& build) {
  const auto* found = std::find_if(originals.begin(), originals.end(), [&](const Original& o) {
    return o.routine == routine && o.target == target && o.rounding == rounds(routine, build);
  });
  if (found == originals.end()) throw std::logic_error("a listing without a digest");
  return found->digest;
}

constexpr Digest no_digest{};

/// CosSin with two shifts by one, for an 8088.
constexpr Digest two_shifts{76, "39f11737eba35c94059943c69a65960f0f6b662204c62397c227463f4bfcf951"};

/// ConcatXforms for the 8088 with the carry that the listing loses.
constexpr Digest with_carry{403,
                            "f43cf72275325db809755e61bd5b5ec8ea67d722a8ab205147107a3e89164001"};

}  // namespace

Source source_of(Routine routine, Target target, const Build& build) {
  const bool i8088 = target == Target::i8088;
  if (build.chapter_52) {
    if (routine == Routine::concat) {
      return {"listing 52.4, which is C; the assembly is ours", no_digest};
    }
    return {"listing 52.9", no_digest};
  }
  if (routine == Routine::cossin && i8088 && !build.shl_as_printed) {
    return {"listing 54.1, but each SHL BX,2 is two shifts by one", two_shifts};
  }
  if (routine == Routine::concat && i8088 && build.repaired) {
    return {"listing 54.1, but the translation is added with its carry", with_carry};
  }
  if (routine == Routine::div && i8088 && build.endif_as_scanned && !build.div_rounding) {
    return {"listing 54.1 as scanned, which is not the author's code", no_digest};
  }
  return {"listing 54.1", original(routine, target, build), true};
}

std::string source_comment(Routine routine, Target target, const Build& build) {
  const Source source = source_of(routine, target, build);
  std::string text = "; source: ";
  text.append(source.printed).append("\n; digest: ");
  if (source.digest.instructions == 0) return text.append("none recorded\n");
  text.append(source.digest.sha256).append(source.is_original ? ", the author's, " : ", ours, ");
  return text.append(std::to_string(source.digest.instructions)).append(" instructions\n");
}

}  // namespace x86model
