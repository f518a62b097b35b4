// The fuzzer of one target: libFuzzer calls this with inputs of its own making.

#include "tests/fuzz/fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return tuberia::fuzz::require_well(tuberia::fuzz::try_options({data, size}));
}
