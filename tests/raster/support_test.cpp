#include <catch2/catch.hpp>

#include "tests/support/random.hpp"
#include "tests/support/sha256.hpp"

namespace tuberia::test {

namespace {

std::string digest_of(std::string_view text) {
  Sha256 digest;
  digest.add(std::as_bytes(std::span(text)));
  return digest.hex();
}

}  // namespace

TEST_CASE("support: splitmix64 with seed 1 begins as published", "[support]") {
  Random random(1);
  CHECK(random.u64() == 0x910a2dec89025cc1u);
  CHECK(random.u64() == 0xbeeb8da1658eec67u);
  CHECK(random.u64() == 0xf893a2eefb32555eu);
}

TEST_CASE("support: SHA-256 gives the digests of FIPS 180-4", "[support]") {
  CHECK(digest_of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest_of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_CASE("support: SHA-256 does not care about portions", "[support]") {
  Sha256 portions;
  for (int i = 0; i < 1000; ++i) portions.add(std::as_bytes(std::span("a", 1)));
  CHECK(portions.hex() == digest_of(std::string(1000, 'a')));
}

}  // namespace tuberia::test
