#include "accuracy_budget.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "limits.h"
#include "options.h"
#include "say.h"

using namespace LAMMPS_NS;
using swellflow::Figure;
using swellflow::rounded;

namespace {

std::string padded(const std::string &text, std::size_t width) { return text + std::string(width > text.size() ? width - text.size() : 0, ' '); }

/// 0 for what is fine, 1 for what is to be watched, 2 for what is poor; within each, nearer to the next is worse.
double badness(const Figure &figure)
{
  if (figure.is_poor()) return 2.0 + (std::isfinite(figure.value) ? 1.0 - figure.poor / figure.value : 1.0);
  return figure.is_fine() ? 0.0 : 1.0 + (figure.value - figure.watch) / (figure.poor - figure.watch);
}

}  // namespace

void LAMMPS_NS::print_accuracy_budget(LAMMPS *lmp)
{
  const std::vector<Figure> figures = swellflow::accuracy_of(lmp);
  if (figures.empty()) return;
  std::size_t width = 0;
  for (const Figure &figure : figures) width = std::max(width, figure.name.size() + 2);
  say(lmp, padded("Accuracy of the run", width + 2) + padded("value", 12) + padded("fine up to", 12) + padded("poor from", 12));
  const Figure *worst = &figures.front();
  for (const Figure &figure : figures) {
    say(lmp, "  " + padded(figure.name, width) + padded(rounded(figure.value), 12) + padded(rounded(figure.watch), 12) + padded(rounded(figure.poor), 12) + figure.word());
    if (badness(figure) > badness(*worst)) worst = &figure;
  }
  say(lmp, worst->is_fine() ? std::string("  All is fine.") : "  Worst is the " + worst->name + " (" + worst->place + "): " + worst->remedy + ".");
}
