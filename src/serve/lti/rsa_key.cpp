// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/rsa_key.h"

#include <openssl/bio.h>
#include <openssl/bn.h>
#include <openssl/core_names.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/param_build.h>
#include <openssl/pem.h>
#include <openssl/rsa.h>

#include <array>
#include <vector>

namespace soarbox::lti {
namespace {

constexpr int kFewestBits = 2048, kMostBits = 8192;
constexpr std::size_t kNewBits = 2048;

template <auto Free>
struct Freer {
  template <typename Object>
  void operator()(Object* object) const {
    Free(object);
  }
};
using Number = std::unique_ptr<BIGNUM, Freer<BN_free>>;
using Digest = std::unique_ptr<EVP_MD_CTX, Freer<EVP_MD_CTX_free>>;
using KeyContext = std::unique_ptr<EVP_PKEY_CTX, Freer<EVP_PKEY_CTX_free>>;
using Builder = std::unique_ptr<OSSL_PARAM_BLD, Freer<OSSL_PARAM_BLD_free>>;
using Parameters = std::unique_ptr<OSSL_PARAM, Freer<OSSL_PARAM_free>>;
using Buffer = std::unique_ptr<BIO, Freer<BIO_free>>;

const unsigned char* BytesOf(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

std::shared_ptr<EVP_PKEY> Shared(EVP_PKEY* key) {
  return {key, EVP_PKEY_free};
}

std::string NumberOf(EVP_PKEY* key, const char* name) {
  BIGNUM* got = nullptr;
  if (EVP_PKEY_get_bn_param(key, name, &got) != 1) return {};
  const Number number(got);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(BN_num_bytes(number.get())));
  BN_bn2bin(number.get(), bytes.data());
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::optional<PublicKey> PublicKey::FromNumbers(std::string_view modulus, std::string_view exponent) {
  constexpr std::size_t kMostBytes = 2 + kMostBits / 8, kMostExponentBytes = 8;
  if (modulus.size() > kMostBytes || exponent.size() > kMostExponentBytes) return std::nullopt;
  const Number n(BN_bin2bn(BytesOf(modulus), static_cast<int>(modulus.size()), nullptr)),
      e(BN_bin2bn(BytesOf(exponent), static_cast<int>(exponent.size()), nullptr));
  if (n == nullptr || e == nullptr || BN_num_bits(n.get()) < kFewestBits || BN_num_bits(n.get()) > kMostBits ||
      !BN_is_odd(n.get()) || !BN_is_odd(e.get()) || BN_is_one(e.get()))
    return std::nullopt;
  const Builder builder(OSSL_PARAM_BLD_new());
  if (builder == nullptr || OSSL_PARAM_BLD_push_BN(builder.get(), OSSL_PKEY_PARAM_RSA_N, n.get()) != 1 ||
      OSSL_PARAM_BLD_push_BN(builder.get(), OSSL_PKEY_PARAM_RSA_E, e.get()) != 1)
    return std::nullopt;
  const Parameters parameters(OSSL_PARAM_BLD_to_param(builder.get()));
  const KeyContext context(EVP_PKEY_CTX_new_from_name(nullptr, "RSA", nullptr));
  EVP_PKEY* key = nullptr;
  if (parameters == nullptr || context == nullptr || EVP_PKEY_fromdata_init(context.get()) != 1 ||
      EVP_PKEY_fromdata(context.get(), &key, EVP_PKEY_PUBLIC_KEY, parameters.get()) != 1)
    return std::nullopt;
  return PublicKey(Shared(key));
}

bool PublicKey::Verify(std::string_view text, std::string_view signature) const {
  const Digest digest(EVP_MD_CTX_new());
  // PKCS #1 v1.5 with SHA-256 is the default for such a key: RS256.
  return digest != nullptr && EVP_DigestVerifyInit(digest.get(), nullptr, EVP_sha256(), nullptr, key_.get()) == 1 &&
         EVP_DigestVerify(digest.get(), BytesOf(signature), signature.size(), BytesOf(text), text.size()) == 1;
}

std::optional<PrivateKey> PrivateKey::New() {
  EVP_PKEY* const key = EVP_PKEY_Q_keygen(nullptr, nullptr, "RSA", kNewBits);
  return key == nullptr ? std::nullopt : std::optional(PrivateKey(Shared(key)));
}

std::optional<PrivateKey> PrivateKey::FromPem(const std::string& text) {
  const Buffer buffer(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  EVP_PKEY* const key = buffer == nullptr ? nullptr : PEM_read_bio_PrivateKey(buffer.get(), nullptr, nullptr, nullptr);
  if (key == nullptr) return std::nullopt;
  PrivateKey read(Shared(key));
  if (EVP_PKEY_get_base_id(key) != EVP_PKEY_RSA || EVP_PKEY_get_bits(key) < kFewestBits) return std::nullopt;
  return read;
}

std::string PrivateKey::ToPem() const {
  const Buffer buffer(BIO_new(BIO_s_mem()));
  if (buffer == nullptr ||
      PEM_write_bio_PrivateKey(buffer.get(), key_.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1)
    return {};
  char* text = nullptr;
  const long bytes = BIO_get_mem_data(buffer.get(), &text);
  return {text, static_cast<std::size_t>(bytes)};
}

std::string PrivateKey::Sign(std::string_view text) const {
  const Digest digest(EVP_MD_CTX_new());
  std::size_t bytes = 0;
  if (digest == nullptr || EVP_DigestSignInit(digest.get(), nullptr, EVP_sha256(), nullptr, key_.get()) != 1 ||
      EVP_DigestSign(digest.get(), nullptr, &bytes, BytesOf(text), text.size()) != 1)
    return {};
  std::string signature(bytes, '\0');
  if (EVP_DigestSign(digest.get(), reinterpret_cast<unsigned char*>(signature.data()), &bytes, BytesOf(text),
                     text.size()) != 1)
    return {};
  signature.resize(bytes);
  return signature;
}

std::string PrivateKey::modulus() const {
  return NumberOf(key_.get(), OSSL_PKEY_PARAM_RSA_N);
}

std::string PrivateKey::exponent() const {
  return NumberOf(key_.get(), OSSL_PKEY_PARAM_RSA_E);
}

std::string Hmac(std::string_view key, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned bytes = 0;
  if (HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()), BytesOf(text), text.size(), digest.data(), &bytes) ==
      nullptr)
    return {};
  return {digest.begin(), digest.begin() + bytes};
}

}  // namespace soarbox::lti
