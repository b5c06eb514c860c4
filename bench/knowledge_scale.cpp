// SPDX-License-Identifier: BSD-2-Clause
// Cost of a large semantic memory: building it, its image, cues with few and with many matching objects, accesses,
// spreading. usage: knowledge_scale [OBJECTS [EDGES_EACH]]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>

#include "kernel/longterm/activations.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"
#include "kernel/longterm/semantic_query.h"
#include "kernel/longterm/semantic_records.h"
#include "kernel/longterm/spreading.h"

namespace {

using namespace soarbox::kernel;

template <typename Work>
double Seconds(Work work) {
  // Processor time, because other programs may run at the same time.
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint32_t objects = argc > 1 ? static_cast<std::uint32_t>(std::atoi(argv[1])) : 1'000'000;
  const std::uint32_t each = argc > 2 ? static_cast<std::uint32_t>(std::atoi(argv[2])) : 10;
  SmemSettings settings;
  Knowledge knowledge;
  Activations activations(settings);
  SemanticSearch search(settings, activations);
  std::mt19937 random(1);
  const StoreTerm kind = knowledge.terms().String("kind"), name = knowledge.terms().String("name");
  const StoreTerm next = knowledge.terms().String("next"), weight = knowledge.terms().String("weight");
  StoreTerm features[8];
  for (int n = 0; n < 8; ++n) features[n] = knowledge.terms().String("feature-" + std::to_string(n));

  const double made = Seconds([&] {
    for (std::uint32_t n = 0; n < objects; ++n) {
      const std::uint32_t object = knowledge.AddNew();
      knowledge.AddEdge(object, kind, knowledge.terms().Integer(n % 20));
      knowledge.AddEdge(object, name, knowledge.terms().String("object-" + std::to_string(n)));
      knowledge.AddEdge(object, weight, knowledge.terms().Integer(static_cast<std::int64_t>(random() % 100000)));
      if (n > 0) knowledge.AddEdge(object, next, StoreTerm::Object(static_cast<std::uint32_t>(random() % n)));
      for (std::uint32_t k = 4; k < each; ++k) {
        knowledge.AddEdge(object, features[k % 8],
                          knowledge.terms().Integer(static_cast<std::int64_t>(random() % 1000)));
      }
    }
  });
  std::printf("make: %.2f s, %u objects, %llu augmentations, %.0f MB\n", made, knowledge.object_count(),
              static_cast<unsigned long long>(knowledge.edge_count()),
              static_cast<double>(knowledge.MemoryBytes()) / 1e6);

  LinkWeights weights(settings);
  std::string image;
  const double written = Seconds([&] { image = records::Image(knowledge, activations, weights); });
  Knowledge again;
  Activations active(settings);
  LinkWeights read_weights(settings);
  bool read_well = false;
  const double read = Seconds([&] { read_well = records::ReadImage(image, again, active, read_weights); });
  std::printf("image: %.0f MB, written in %.2f s, read in %.2f s%s\n", static_cast<double>(image.size()) / 1e6, written,
              read, read_well ? "" : " (WRONG)");

  const auto query = [&](const char* what, int rounds, auto cue_of) {
    std::size_t found = 0;
    const double seconds = Seconds([&] {
      for (int n = 0; n < rounds; ++n) {
        const Cue cue = cue_of(n);
        const std::vector<std::uint32_t> answer = search.Find(knowledge, cue, {}, 1);
        found += answer.size();
        if (!answer.empty() && activations.Touch(answer.front())) search.FirstTouched(knowledge, answer.front());
      }
    });
    std::printf("%s: %.2f us each, %zu of %d found\n", what, seconds / rounds * 1e6, found, rounds);
  };
  const auto any_name = [&](int n) {
    return knowledge.terms().String("object-" + std::to_string(static_cast<std::uint32_t>(n) * 7919u % objects));
  };
  query("rare cue", 10000, [&](int n) { return Cue{{{name, any_name(n)}, {kind, StoreTerm()}}, false}; });
  query("common cue", 1000, [&](int n) { return Cue{{{kind, knowledge.terms().Integer(n % 20)}}, false}; });
  query("two common values", 1000, [&](int n) {
    return Cue{{{kind, knowledge.terms().Integer(n % 20)}, {features[4], knowledge.terms().Integer(n)}}, false};
  });
  query("largest number of a twentieth", 5, [&](int n) {
    Cue cue{{{kind, knowledge.terms().Integer(n % 20)}, {weight, StoreTerm()}}, false};
    cue.elements[1].math = MathTest::kMax;
    return cue;
  });
  Spreading spreading(settings, weights);
  std::map<std::uint32_t, double> sources;
  for (std::uint32_t n = 0; n < 20; ++n) sources[static_cast<std::uint32_t>(random() % objects)] = 1;
  const double spread = Seconds([&] { spreading.SetSources(knowledge, sources); });
  std::printf("spreading from 20 sources: %.2f ms, %zu recipients\n", spread * 1e3, spreading.size());
  return 0;
}
