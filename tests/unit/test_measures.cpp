// How far an object has turned, sums over objects, and the file that holds their measures.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "liggghts_plugins/objects/measure_file.h"
#include "liggghts_plugins/objects/orientation.h"
#include "liggghts_plugins/objects/outline.h"

using namespace swellflow;
namespace fs = std::filesystem;

namespace {

constexpr double pi = std::numbers::pi;

Vector2 turned(const Vector2 &r, double angle)
{
  return {std::cos(angle) * r.x() - std::sin(angle) * r.y(), std::sin(angle) * r.x() + std::cos(angle) * r.y()};
}

/// Seven points that have no symmetry, with masses of their own, about their centre of mass.
struct Cloud {
  std::vector<Vector2> x;
  std::vector<double> mass;

  Cloud()
  {
    Vector2 centre = Vector2::Zero();
    double whole = 0.0;
    for (int k = 0; k < 7; ++k) {
      x.emplace_back(std::cos(1.7 * k * k), std::sin(2.3 * k));
      mass.push_back(1.0 + 0.3 * k);
      centre += mass.back() * x.back();
      whole += mass.back();
    }
    for (Vector2 &r : x) r -= centre / whole;
  }
};

std::string whole(const fs::path &file)
{
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class MeasureFiles : public testing::Test {
protected:
  MeasureFiles() : folder(fs::temp_directory_path() / ("swellflow_measures_" + std::to_string(getpid()))) { fs::remove_all(folder); }
  ~MeasureFiles() override { fs::remove_all(folder); }

  static ObjectMeasures object(int id, double area)
  {
    ObjectMeasures measures;
    measures.id = id;
    measures.area = area;
    measures.coordination = 4;
    return measures;
  }

  fs::path folder;
};

}  // namespace

TEST(Orientation, ARigidTurnIsFoundWhateverTheSize)
{
  const Cloud cloud;
  for (const double angle : {-3.1, -1.0, 0.0, 1e-9, 0.7, 3.0}) {
    std::vector<Vector2> now;
    for (const Vector2 &r : cloud.x) now.push_back(1.8 * turned(r, angle));
    EXPECT_NEAR(best_fit_angle(cloud.x, now, cloud.mass), angle, 1e-15) << angle;
  }
}

TEST(Orientation, TheFitHasTheLeastSquares)
{
  const Cloud cloud;
  std::vector<Vector2> now;
  for (std::size_t k = 0; k < cloud.x.size(); ++k) now.push_back(turned(cloud.x[k], 0.4) + Vector2(0.2 * std::sin(5.0 * k), 0.2 * std::cos(3.0 * k)));
  const auto distance = [&](double angle) {
    double sum = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k) sum += cloud.mass[k] * (now[k] - turned(cloud.x[k], angle)).squaredNorm();
    return sum;
  };
  const double best = best_fit_angle(cloud.x, now, cloud.mass);
  EXPECT_LT(distance(best), distance(best + 1e-3));
  EXPECT_LT(distance(best), distance(best - 1e-3));
  EXPECT_GT(std::abs(best - 0.4), 1e-3);  // the points are not where a rigid turn would have taken them
}

TEST(Orientation, TurnsAreCounted)
{
  double counted = 0.0;
  for (int k = 1; k <= 100; ++k) counted = unwrapped_angle(std::remainder(-2.9 * k, 2.0 * pi), counted);
  EXPECT_NEAR(counted, -290.0, 1e-11);
  EXPECT_EQ(unwrapped_angle(0.3, 0.3 + 1e-15), 0.3);  // nothing is left of what was known before
  EXPECT_EQ(unwrapped_angle(1e-9, 0.25), 1e-9);
  EXPECT_NEAR(unwrapped_angle(-3.0, 20.0 * pi + 3.0), 22.0 * pi - 3.0, 1e-13);
}

TEST(Outline, AnOffsetOutlineLiesBeyondTheRing)
{
  EXPECT_NEAR((outline_point({3.0, 4.0}, 0.5) - Vector2(3.3, 4.4)).norm(), 0.0, 1e-15);
  EXPECT_EQ(outline_point({3.0, 4.0}, 0.0), Vector2(3.0, 4.0));
}

TEST(MeasureTotals, SumsAndLargestValues)
{
  std::vector<ObjectMeasures> objects(3);
  for (int k = 0; k < 3; ++k) {
    objects[k].area = 1.0 + k;
    objects[k].area_ratio = 0.9 - 0.1 * k;
    objects[k].rotation = k == 1 ? -7.0 : 1.0;
    objects[k].contact_pressure = -1.0 - k;
    objects[k].coordination = 2 * k;
    objects[k].centroid = {100.0, 3.0 + k};
  }
  const MeasureTotals totals(objects);
  EXPECT_EQ(totals.number(), 3.0);
  EXPECT_EQ(totals.sum[MeasureTotals::AREA], 6.0);
  EXPECT_EQ(totals.mean(MeasureTotals::COORDINATION), 2.0);
  EXPECT_EQ(totals.mean(MeasureTotals::HEIGHT), 4.0);
  EXPECT_EQ(totals.mean(MeasureTotals::ROTATION), 3.0);
  EXPECT_EQ(totals.largest_or_0(MeasureTotals::LARGEST_ROTATION), 7.0);
  EXPECT_EQ(totals.largest_or_0(MeasureTotals::LARGEST_PRESSURE), -1.0);
  EXPECT_NEAR(totals.largest_or_0(MeasureTotals::MINUS_AREA_RATIO), -0.7, 1e-15);
  EXPECT_EQ(MeasureTotals({}).largest_or_0(MeasureTotals::LARGEST_PRESSURE), 0.0);
  EXPECT_EQ(MeasureTotals({}).mean(MeasureTotals::AREA), 0.0);
}

TEST_F(MeasureFiles, LinesAreInOrderAndTheHeaderNamesUnits)
{
  const MeasureFile file(folder / "a" / "objects.csv", unit_names("si"));
  file.begin(0.0);
  file.append(10, 0.1, {object(7, 1.0 / 3.0), object(2, 0.5)});
  std::istringstream lines(whole(folder / "a" / "objects.csv"));
  std::string header, first, second, rest;
  std::getline(lines, header), std::getline(lines, first), std::getline(lines, second);
  EXPECT_TRUE(header.starts_with("step,time [s],id,centroid_x [m],centroid_y [m],velocity_x [m/s],velocity_y [m/s],rotation [rad],spin [rad/s],")) << header;
  EXPECT_NE(header.find(",area [m^2],area_ratio,"), std::string::npos) << header;
  EXPECT_TRUE(header.ends_with(",contact_pressure [Pa],coordination,concentration,uptake [m^2]")) << header;
  EXPECT_TRUE(first.starts_with("10,0.1,2,")) << first;
  EXPECT_NE(second.find(",0.3333333333333333,"), std::string::npos) << second;
  EXPECT_TRUE(second.ends_with(",4,0,0")) << second;
  EXPECT_EQ(std::count(first.begin(), first.end(), ','), std::count(header.begin(), header.end(), ','));
  EXPECT_FALSE(std::getline(lines, rest));
  EXPECT_EQ(MeasureFile(folder / "b.csv", unit_names("lj")).header().find('[', header.find("rotation [rad]") + 1), std::string::npos);
}

TEST_F(MeasureFiles, ALaterRunReplacesWhatIsAfterItsStartAndHalfALine)
{
  const fs::path path = folder / "objects.csv";
  {
    const MeasureFile file(path, unit_names("si"));
    file.begin(0.0);
    for (int step : {0, 10, 20, 30}) file.append(step, 0.1 * step, {object(1, step)});
    std::ofstream(path, std::ios::app) << "40,4,1,0.5";
  }
  const MeasureFile again(path, unit_names("si"));
  EXPECT_NE(whole(path).find("\n30,3,"), std::string::npos);  // opening alone takes nothing away
  again.begin(2.0);
  again.append(20, 2.0, {object(1, 99.0)});
  const std::string text = whole(path);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_NE(text.find("\n0,0,1,"), std::string::npos);
  EXPECT_NE(text.find("\n10,1,1,"), std::string::npos);
  EXPECT_NE(text.find("\n20,2,1,"), std::string::npos);
  EXPECT_EQ(text.find(",20,"), std::string::npos);  // the area that the first run had at that time
  EXPECT_EQ(text.find("\n30,"), std::string::npos);
  EXPECT_EQ(text.find("\n40,"), std::string::npos);
}

TEST_F(MeasureFiles, SomethingElseIsNotOverwritten)
{
  fs::create_directories(folder);
  std::ofstream(folder / "thesis.tex") << "\\documentclass{book}\n";
  const MeasureFile file(folder / "thesis.tex", unit_names("si"));
  try {
    file.begin(0.0);
    FAIL() << "it was overwritten";
  } catch (const std::runtime_error &refusal) {
    for (const char *word : {"thesis.tex", "must hold measures of objects", "\\documentclass", "name another"})
      EXPECT_NE(std::string(refusal.what()).find(word), std::string::npos) << refusal.what();
  }
  EXPECT_EQ(whole(folder / "thesis.tex"), "\\documentclass{book}\n");
  EXPECT_THROW(MeasureFile("/dev/null/x/objects.csv", unit_names("si")), std::runtime_error);
  EXPECT_THROW(MeasureFile(folder, unit_names("si")), std::runtime_error);
  EXPECT_THROW(MeasureFile("/dev/null", unit_names("si")), std::runtime_error);
}
