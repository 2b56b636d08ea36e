// The command `accuracy`: what it sets where lines leave it out, what single knobs override, and how long it holds.
#include "fake_fluid.h"
#include "liggghts_plugins/accuracy.h"

using namespace swellflow_test;

namespace {

const std::string preamble = "units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary f f p\nnewton off\ncommunicate single vel yes\n"
                             "region box block 0 3 0 2 -0.005 0.005 units box\n";
const std::string disc = "create_objects disk 1 1 density 1000 cds 0.1 diameter ", move = "fix move all rigid/cds\ntimestep 1e-3\n";
const std::string water = "fix water all fluid/ib density 1000 viscosity 0.01 cells ";

/// The box, `accuracy` above it or below, and what else a scene needs.
void make_box(FakeFluidScene &scene, const std::string &above, const std::string &below = "")
{
  scene.script(preamble + above + "create_box 1 box\n" + below);
  scene.settings();
}

/// Of all objects together.
int ring_points(const FakeFluidScene &scene) { return static_cast<int>(scene.atom()->natoms) - 1; }

const swellflow::AccuracyPreset &preset(const std::string &name)
{
  for (const auto &known : swellflow::accuracy_presets())
    if (known.name == name) return known;
  throw std::invalid_argument(name);
}

}  // namespace

class Accuracy : public ::testing::TestWithParam<std::string> {};

TEST_P(Accuracy, SetsWhatLinesLeaveOut)
{
  const auto &set = preset(GetParam());
  FakeFluidScene scene;
  make_box(scene, "accuracy " + GetParam() + "\n");
  scene.script(disc + "0.5\n" + move + water + "auto every 20\nrun 1\n");
  EXPECT_EQ(ring_points(scene), *set.points);
  EXPECT_EQ(scene.talk.options.cells, (std::array<int, 3>{6 * *set.across, 4 * *set.across, 0}));
  EXPECT_EQ(scene.talk.options.cfl, *set.cfl);
}

TEST_P(Accuracy, LeavesWhatLinesSay)
{
  FakeFluidScene scene;
  make_box(scene, "", "accuracy " + GetParam() + "\n");
  scene.script(disc + "0.5 points 17\n" + move + water + "30 20 every 20 cfl 0.25\nrun 1\n");
  EXPECT_EQ(ring_points(scene), 17);
  EXPECT_EQ(scene.talk.options.cells, (std::array<int, 3>{30, 20, 0}));
  EXPECT_EQ(scene.talk.options.cfl, 0.25);
}

TEST_P(Accuracy, ChoosesNoStepWhereThereIsOne)
{
  FakeFluidScene scene;
  make_box(scene, "accuracy " + GetParam() + "\n");
  scene.script(disc + "0.5\n" + move + water + "auto\nrun 1\n");
  EXPECT_EQ(scene.talk.options.cfl, 0.0);
  EXPECT_EQ(scene.talk.options.dem_steps_per_fluid_step, 1);
}

INSTANTIATE_TEST_SUITE_P(Presets, Accuracy, ::testing::Values("fast", "balanced", "accurate"), [](const auto &info) { return info.param; });

TEST(AccuracyCommand, TheSmallestObjectCountsAndCellsAreSquare)
{
  FakeFluidScene scene;
  make_box(scene, "accuracy balanced\n");
  scene.script(disc + "0.5\ncreate_objects disk 2.5 0.5 density 1000 cds 0.1 diameter 0.3\n" + move + water + "auto\nrun 1\n");
  const double wanted = 0.3 / *preset("balanced").across;
  const auto &cells = scene.talk.options.cells;
  EXPECT_EQ(2 * cells[0], 3 * cells[1]);
  EXPECT_NEAR(3.0 / cells[0], wanted, 1.5 / (3.0 / wanted) * wanted);  // the next numbers are 3 and 2 cells away
}

TEST(AccuracyCommand, WithoutItNothingChanges)
{
  FakeFluidScene scene;
  make_box(scene, "");
  scene.script(disc + "0.5\n" + move + water + "30 20 every 20\nrun 1\n");
  EXPECT_EQ(ring_points(scene), 20);
  EXPECT_EQ(scene.talk.options.cfl, 0.0);
}

TEST(AccuracyCommand, TheLastOneCounts)
{
  FakeFluidScene scene;
  make_box(scene, "accuracy fast\n", "accuracy accurate\n");
  scene.script(disc + "0.5\n");
  EXPECT_EQ(ring_points(scene), *preset("accurate").points);
}

TEST(AccuracyCommand, EndsWithItsBox)
{
  FakeFluidScene scene;
  const std::string fast = "accuracy fast\n";
  const std::array<std::string, 2> nowhere{"", ""}, above{fast, ""}, below{"", fast};
  for (const auto &[at, points] : {std::pair{above, 24}, {nowhere, 20}, {below, 24}, {nowhere, 20}, {nowhere, 20}}) {
    make_box(scene, at[0], at[1]);
    scene.script(disc + "0.5\n");
    EXPECT_EQ(ring_points(scene), points);
    scene.script("clear\n");
  }
}
