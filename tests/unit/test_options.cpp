// What users may write, and what they are told when they write something else.
#include <gtest/gtest.h>

#include "liggghts_plugins/fluid_script.h"
#include "liggghts_plugins/object_list.h"
#include "liggghts_plugins/options.h"
#include "complaints.h"

using namespace swellflow;
using namespace swellflow_test;

namespace {

std::vector<std::string> words_of(const std::string &text)
{
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (end > begin) words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// What create_objects makes of a line.
std::vector<NewObject> made(const std::string &line, const std::string &file_text = "")
{
  std::vector<std::string> words = words_of(line);
  std::vector<char *> arg;
  for (std::string &word : words) arg.push_back(word.data());
  ObjectScene scene;
  scene.text_of_file = [&](const std::string &) { return file_text; };
  scene.require_room = [](const std::string &, double) {};
  scene.box = [] { return PlaneBox{.low = {0, 0}, .high = {1, 1}, .periodic = {true, false}}; };
  return read_object_list(arg.size(), arg.data(), scene).objects;
}

/// The message that create_objects ends with.
std::string complaint(const std::string &line, const std::string &file_text = "")
{
  return complaint_of([&] { made(line, file_text); });
}

/// What fix fluid/ib makes of the words behind the ones that it cannot do without, in a box of 2 x 1 that is periodic along x or not.
FluidScript fluid(const std::string &words, bool periodic_x = false, bool periodic_y = false)
{
  Arguments line("fix water fluid/ib", words_of("cells 40 20 density 1000 viscosity 0.01 " + words));
  return FluidScript(line, {.periodic = {periodic_x, periodic_y}, .length = {2.0, 1.0}, .smallest_object = {}}, {});
}

std::string fluid_complaint(const std::string &words, bool periodic_x = false, bool periodic_y = false)
{
  return complaint_of([&] { fluid(words, periodic_x, periodic_y); });
}

}  // namespace

TEST(Options, ReadEveryKind)
{
  double rate = 1.0, untouched = 7.0;
  int count = 0, choice = 0;
  bool absorb = true, quiet = false;
  std::string folder;
  std::vector<std::string> fields;
  double wall = 0.0;
  Options options("fix a b");
  options.number("rate", rate, Range::positive(), "length per time", "growth");
  options.number("untouched", untouched, Range::any(), "", "kept");
  options.integer("count", count, Range::at_least(1), "how many");
  options.choice("kernel", choice, {"roma_1999", "peskin_2002"}, "delta kernel");
  options.yes_no("absorb", absorb, "drinks");
  options.flag("quiet", quiet, "no output");
  options.text("folder", folder, "where to");
  options.list("fields", fields, {"velocity", "pressure"}, "what");
  options.custom("wall", [&](Arguments &line) { wall += line.number("wall"); }, "speed of a wall").repeatable();
  Arguments line("fix a b", words_of("fields velocity pressure rate 2.5e-1 count 3 kernel peskin_2002 absorb no quiet folder post wall 1 wall 2"));
  options.parse(line);
  EXPECT_EQ(rate, 0.25);
  EXPECT_EQ(untouched, 7.0);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(choice, 1);
  EXPECT_FALSE(absorb);
  EXPECT_TRUE(quiet);
  EXPECT_EQ(folder, "post");
  EXPECT_EQ(fields, (std::vector<std::string>{"velocity", "pressure"}));
  EXPECT_EQ(wall, 3.0);
  EXPECT_TRUE(options.given("wall"));
  EXPECT_FALSE(options.given("untouched"));
}

TEST(CreateObjectsLine, MakesTheDiscThatItNames)
{
  const auto objects = made("disk 0.5 0.25 diameter 0.12 points 21 density 1500 cds 0.1 type 2 mass equal");
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].centre, Vector2(0.5, 0.25));
  EXPECT_EQ(objects[0].shape->ring.size(), 21u);
  EXPECT_EQ(objects[0].shape->share, MassShare::equal);
  EXPECT_EQ(objects[0].type, 2);
}

TEST(CreateObjectsLine, LatticeSpacingMayDifferPerDirection)
{
  EXPECT_EQ(made("lattice 3 2 origin 0.1 0.2 spacing 0.3 disk diameter 0.1 density 1")[5].centre, Vector2(0.1 + 2 * 0.3, 0.5));
  EXPECT_EQ(made("lattice 3 2 origin 0.1 0.2 spacing 0.3 0.4 disk diameter 0.1 density 1")[3].centre, Vector2(0.1, 0.2 + 0.4));
}

TEST(CreateObjectsLine, SaysWhatIsWrong)
{
  const std::string good = "disk 0.5 0.5 diameter 0.1 density 1000";
  expect_all(complaint(""), {"create_objects", "not enough arguments", "disk or ellipse or outline or lattice or random or file"});
  expect_all(complaint("ball 0 0"), {"'form' must be disk or ellipse or outline or lattice or random or file", "'ball'"});
  expect_all(complaint("disk 0.5"), {"create_objects disk", "not enough arguments for 'y'"});
  expect_all(complaint("disk 0.5 north diameter 1 density 1"), {"'y' must be a number", "'north'"});
  expect_all(complaint("disk 0.5 0.5 density 1000"), {"keyword 'diameter' is missing", "> 0"});
  expect_all(complaint("disk 0.5 0.5 diameter 0.1"), {"keyword 'density' is missing"});
  expect_all(complaint("disk 0.5 0.5 diameter 0 density 1"), {"'diameter' must be a number > 0", "'0'"});
  expect_all(complaint("disk 0.5 0.5 diameter -0.1 density 1"), {"'diameter' must be a number > 0", "'-0.1'"});
  expect_all(complaint("disk 0.5 0.5 diameter 0.1 density -1500"), {"'density' must be a number > 0", "'-1500'"});
  expect_all(complaint("disk 0.5 0.5 diameter nan density 1"), {"'diameter' must be a number > 0", "'nan'"});
  expect_all(complaint("disk 0.5 0.5 diameter inf density 1"), {"'diameter' must be a number > 0", "'inf'"});
  expect_all(complaint(good + " points 2"), {"'points' must be a whole number in [3, 10000]", "'2'"});
  expect_all(complaint(good + " points 20.5"), {"'points' must be a whole number", "'20.5'"});
  expect_all(complaint(good + " points 1e12"), {"'points' must be a whole number", "'1e12'"});
  expect_all(complaint(good + " cds 0.6"), {"'cds' must be a number in (0, 0.5] (of the diameter)", "'0.6'"});
  expect_all(complaint(good + " type 0"), {"'type' must be a whole number >= 1", "'0'"});
  expect_all(complaint(good + " mass heavy"), {"'mass' must be hub_half or equal", "'heavy'"});
  expect_all(complaint(good + " colour red"), {"unknown keyword 'colour'", "known are diameter, density, points, angle, spokes, cds, reach, cds_points, hub_cds, type, mass, sizes"});
  expect_all(complaint(good + " points"), {"not enough arguments for 'points'", "in [3, 10000]"});
  expect_all(complaint(good + " density 2"), {"keyword 'density' is given twice"});
  expect_all(complaint("lattice 4 0 origin 0 0 spacing 1 disk diameter 0.1 density 1"), {"'objects along y' must be a whole number >= 1"});
  expect_all(complaint("lattice 4 4 at 0 0"), {"create_objects lattice", "here must stand 'origin'", "'at'"});
  expect_all(complaint("lattice 4 4 origin 0 0 spacing 0.2 0 disk diameter 0.1 density 1"), {"'spacing' must be a number > 0"});
}

TEST(CreateObjectsLine, AFileOfMeasuresGivesTheLastOfThem)
{
  const std::string file = "step,time [s],id,centroid_x [m],centroid_y [m],rotation [rad],diameter_of_area [m]\n"
                           "0,0,1,0.1,0.2,0,0.05\n0,0,2,0.4,0.2,0,0.06\n10,0.1,1,0.11,0.19,1.5707963267948966,0.04\n10,0.1,2,-0.1,0.18,0,0.05\n";
  const auto objects = made("file bed.csv density 1000", file);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].centre, Vector2(0.11, 0.19));
  EXPECT_NEAR(objects[0].angle, 90.0, 1e-12);
  EXPECT_EQ(objects[0].diameter, 0.04);
  EXPECT_NEAR(objects[1].centre.x(), 0.9, 1e-12) << "in the box, where it is periodic";
}

TEST(CreateObjectsLine, FileErrorsNameFileAndLine)
{
  const std::string line = "file beads.csv density 1000";
  EXPECT_EQ(made(line, "x,y,diameter\n0.1,0.2,0.05\n").size(), 1u);
  expect_all(complaint(line, ""), {"beads.csv", "must hold a line of names"});
  expect_all(complaint(line, "x,y,diameter\n"), {"beads.csv line 1", "at least one line of numbers"});
  expect_all(complaint(line, "x,y,size\n0,0,1\n"), {"beads.csv line 1", "'size'", "known are x, y, diameter"});
  expect_all(complaint(line, "x,y,x\n0,0,1\n"), {"beads.csv line 1", "'x' is there twice"});
  expect_all(complaint(line, "x,diameter\n0,0.1\n"), {"beads.csv", "column 'y' must be there"});
  expect_all(complaint(line, "x,y,diameter\n0,0,0.1\n0.5,0.5\n"), {"beads.csv line 3", "3 numbers", "there are 2"});
  expect_all(complaint(line, "# c\n\nx,y,diameter\n0,zero,0.1\n"), {"beads.csv line 4", "'y' must be a number", "'zero'"});
  expect_all(complaint(line, "x,y,diameter\n0,0,-1\n"), {"beads.csv line 2", "'diameter' must be a number > 0", "'-1'"});
  expect_all(complaint(line, "x,y,diameter,points\n0,0,1,3.5\n"), {"beads.csv line 2", "'points' must be a whole number", "'3.5'"});
  expect_all(complaint(line, "x,y\n0,0\n"), {"create_objects file", "keyword 'diameter' is missing"});
  expect_all(complaint("file"), {"create_objects file", "not enough arguments for 'file'"});
}

TEST(FluidLine, SidesAreWallsPeriodicOrAsTheLineSays)
{
  const FluidOptions plain = fluid("").options();
  for (int side = 0; side < 4; ++side) EXPECT_EQ(plain.sides[side], SideKind::wall);
  EXPECT_EQ(plain.dem_steps_per_fluid_step, 1);
  EXPECT_EQ(plain.cfl, 0.0);
  const FluidOptions flow = fluid("inflow xlo uniform 0.1 0 outflow xhi slip ylo wall yhi velocity 0.1 0").options();
  EXPECT_EQ(flow.sides[0], SideKind::inflow);
  EXPECT_EQ(flow.sides[1], SideKind::outflow);
  EXPECT_EQ(flow.sides[2], SideKind::slip);
  EXPECT_EQ(flow.sides[3], SideKind::wall);
  const FluidOptions held = fluid("mean_velocity x v_u mean_velocity y 0.5", true, true).options();
  for (int side = 0; side < 4; ++side) EXPECT_EQ(held.sides[side], SideKind::periodic);
  EXPECT_TRUE(held.controlled[0] && held.controlled[1]);
  EXPECT_EQ(fluid("forcing multi 4").options().forcing_loops, 4);
  EXPECT_EQ(fluid("forcing implicit advection none kernel yang_2009").options().kernel, "yang_2009");
}

TEST(FluidLine, KnowsWhetherAnythingVaries)
{
  EXPECT_FALSE(fluid("wall yhi velocity 0.1 0 body_force 1 2 initial_velocity v_u v_v").varies());
  EXPECT_TRUE(fluid("wall yhi velocity v_u 0").varies());
  EXPECT_TRUE(fluid("pressure_drop v_p 0", true).varies());
}

TEST(FluidLine, StartsLinearBetweenTheWallsThatMove)
{
  const std::string linear = "initial_velocity linear ";
  EXPECT_FALSE(fluid("wall yhi velocity 1 0").options().linear_start);
  EXPECT_EQ(fluid(linear + "wall yhi velocity 1 0", true).options().linear_start, 1);
  EXPECT_EQ(fluid(linear + "wall yhi velocity 1 0").options().linear_start, 1);
  EXPECT_EQ(fluid(linear + "wall xlo velocity 0 v_u").options().linear_start, 0);
  EXPECT_EQ(fluid(linear, true).options().linear_start, 1);
  EXPECT_EQ(fluid("wall ylo velocity -1 0 inflow xlo uniform 1 0 outflow xhi " + linear).options().linear_start, 1);
  const std::string rule = "between two walls that face each other";
  expect_all(fluid_complaint(linear, true, true), {"fix water fluid/ib", rule, "there are none", "give the initial velocity as VX VY"});
  expect_all(fluid_complaint(linear + "slip ylo wall yhi velocity 1 0"), {rule, "yhi moves and ylo is no wall", "change the sides"});
  expect_all(fluid_complaint(linear + "wall xlo velocity 0 v_u wall yhi velocity 1 0"), {rule, "walls move in x and in y"});
  expect_all(fluid_complaint("initial_velocity linaer"), {"'initial_velocity' must be 'linear', or two numbers", "'linaer'", "change"});
  expect_all(fluid_complaint("initial_velocity 1"), {"not enough arguments for 'initial_velocity, y'"});
}

TEST(FluidLine, KnowsWhenNothingResists)
{
  EXPECT_TRUE(fluid("body_force 1 0", true, true).is_driven_without_resistance());
  EXPECT_TRUE(fluid("pressure_drop v_p 0 slip ylo slip yhi", true).is_driven_without_resistance());
  EXPECT_FALSE(fluid("body_force 1 0 slip ylo", true).is_driven_without_resistance());
  EXPECT_FALSE(fluid("body_force 0 0", true, true).is_driven_without_resistance());
  EXPECT_FALSE(fluid("mean_velocity x 1", true, true).is_driven_without_resistance());
  EXPECT_FALSE(fluid("body_force 0 1 slip ylo slip yhi", true).is_driven_without_resistance());
}

TEST(FluidLine, SaysWhatIsWrong)
{
  expect_all(fluid_complaint("slip xlo wall xlo velocity 0 1"), {"fix water fluid/ib", "described once", "xlo is here twice", "take one"});
  expect_all(fluid_complaint("slip xhi", true), {"a periodic direction has no sides", "'slip xhi'", "boundary x is 'p'", "leave 'slip' out"});
  expect_all(fluid_complaint("wall ylo velocity 0 1", false, true), {"'wall ylo'", "boundary y is 'p'"});
  expect_all(fluid_complaint("inflow xlo uniform 1 0"), {"what flows in must leave", "add 'outflow SIDE'"});
  expect_all(fluid_complaint("inflow xlo uniform -1 0 outflow xhi"), {"points into the box", "on xlo its velocity in x is -1", "change its sign"});
  expect_all(fluid_complaint("inflow yhi parabolic 0 1 outflow ylo"), {"points into the box", "on yhi its velocity in y is 1"});
  expect_all(fluid_complaint("wall yhi velocity 0 0.1"), {"within its plane", "on yhi is 0.1", "set it to 0"});
  expect_all(fluid_complaint("wall yhi velocity 0"), {"not enough arguments for 'wall yhi velocity, y'", "v_NAME"});
  expect_all(fluid_complaint("wall yhi velocity v_ 0"), {"must name its variable behind v_", "'v_'"});
  expect_all(fluid_complaint("wall yhi velocity u 0"), {"'wall yhi velocity, x' must be a number", "or v_NAME of an equal-style variable", "'u'"});
  expect_all(fluid_complaint("inflow xlo 1 0"), {"'inflow' must be uniform or parabolic", "'1'"});
  expect_all(fluid_complaint("pressure_drop 1 0"), {"acts along a periodic direction", "boundary x is not 'p'", "set it to 0"});
  expect_all(fluid_complaint("pressure_drop 1 v_p", true), {"boundary y is not 'p'"});
  expect_all(fluid_complaint("mean_velocity x 1"), {"along a periodic direction", "boundary x is not 'p'", "'inflow'"});
  expect_all(fluid_complaint("mean_velocity z 1"), {"'mean_velocity' must be x or y", "'z'"});
  expect_all(fluid_complaint("mean_velocity x 1 mean_velocity x 2", true), {"once a direction", "'mean_velocity x' is here twice"});
  expect_all(fluid_complaint("mean_velocity x 1 body_force 1 0", true), {"'mean_velocity x'", "'body_force'", "set it to 0"});
  expect_all(fluid_complaint("pressure_drop v_p 0 mean_velocity x 1", true), {"'mean_velocity x'", "'pressure_drop'", "leave 'mean_velocity' out"});
  EXPECT_EQ(fluid_complaint("mean_velocity x 1 body_force 0 1", true), "no error");
  expect_all(fluid_complaint("cfl 0.5"), {"'cfl'", "'every' is missing", "add 'every N'"});
  expect_all(fluid_complaint("cfl 0 every 5"), {"'cfl' must be a number > 0", "'0'"});
  expect_all(fluid_complaint("forcing multi"), {"not enough arguments for 'forcing multi'", "in [1, 1000]"});
  expect_all(fluid_complaint("forcing twice"), {"'forcing' must be direct or multi or implicit", "'twice'"});
  expect_all(fluid_complaint("kernel roma"), {"'kernel' must be roma_1999 or peskin_2002 or yang_2009 or gruninger_2025", "'roma'"});
  expect_all(fluid_complaint("advection upwind"), {"'advection' must be central or bounded or none", "'upwind'"});
}
