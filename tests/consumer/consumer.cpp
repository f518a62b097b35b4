#include <cstdio>
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
int main() {
  using namespace tuberia;
  RenderTarget target = *RenderTarget::create(64, 64);
  Pipeline pipeline;
  std::puts("ok");
}
