// LIGGGHTS with our styles, in this process, for tests of scenes without a fluid.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "atom.h"
#include "domain.h"
#include "fix.h"
#include "input.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include "liggghts_plugins/fix_objects.h"
#include "liggghts_plugins/register_styles.h"

namespace swellflow_test {

class DryScene {
public:
  /// All ranks of `comm` make one together; MPI_COMM_SELF: each rank a scene of its own, to compare with.
  explicit DryScene(MPI_Comm comm = MPI_COMM_WORLD)
  {
    // Not "none": LIGGGHTS' meshes print without asking. SWELLFLOW_TEST_SCREEN names a file for a look at its messages.
    const char *screen = std::getenv("SWELLFLOW_TEST_SCREEN");
    const char *arguments[] = {"test", "-screen", screen ? screen : "/dev/null", "-log", "none"};
    lammps_open(5, const_cast<char **>(arguments), comm, &handle_);
    swellflow::register_styles(lmp(), {});
  }
  ~DryScene() { lammps_close(handle_); }
  DryScene(const DryScene &) = delete;
  DryScene &operator=(const DryScene &) = delete;

  LAMMPS_NS::LAMMPS *lmp() const { return static_cast<LAMMPS_NS::LAMMPS *>(handle_); }
  LAMMPS_NS::Atom *atom() const { return lmp()->atom; }

  /// Runs the lines of a script.
  void script(const std::string &text)
  {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      if (line.find_first_not_of(' ') != std::string::npos) lammps_command(handle_, line.c_str());
      begin = end + 1;
    }
  }

  /// A box with what objects need, and frictionless linear contacts of stiffness 1e4.
  void box(const std::string &region, const std::string &boundary = "f f p", const std::string &skin = "0.01",
           const std::string &thickness = "-0.005 0.005")
  {
    script("units si\ndimension 2\natom_style hybrid granular molecular\natom_modify map array\nboundary " + boundary +
           "\nnewton off\ncommunicate single vel yes\nsoft_particles yes\n");
    script("region box block " + region + " " + thickness + " units box\ncreate_box 1 box\n");
    settings(skin);
  }
  /// What a script says again after a read_restart.
  void settings(const std::string &skin = "0.01")
  {
    script("neighbor " + skin + " bin\nneigh_modify delay 0 exclude molecule all\n");
    script("fix m1 all property/global kn peratomtypepair 1 1e4\n"
           "fix m2 all property/global kt peratomtypepair 1 0\n"
           "fix m3 all property/global gamman_abs peratomtypepair 1 0\n"
           "fix m4 all property/global gammat_abs peratomtypepair 1 0\n"
           "fix m5 all property/global coefficientFriction peratomtypepair 1 0\n");
    script("pair_style gran model hooke/stiffness tangential history absolute_damping on\npair_coeff * *\n");
  }

  LAMMPS_NS::FixObjects *objects() const { return LAMMPS_NS::find_objects(lmp()); }
  LAMMPS_NS::Fix *fix(const std::string &id) const { return lmp()->modify->fix[lmp()->modify->find_fix(id.c_str())]; }

  /// x, y, vx, vy, radius, mass by tag, unwrapped, of all atoms, on every rank.
  using State = std::map<int, std::array<double, 6>>;
  State state() const
  {
    std::vector<double> own;
    for (int i = 0; i < atom()->nlocal; i++) {
      double x[3];
      lmp()->domain->unmap(atom()->x[i], atom()->image[i], x);
      own.insert(own.end(), {static_cast<double>(atom()->tag[i]), x[0], x[1], atom()->v[i][0], atom()->v[i][1], atom()->radius[i],
                             atom()->rmass[i]});
    }
    int size = own.size(), ranks;
    MPI_Comm_size(lmp()->world, &ranks);
    std::vector<int> sizes(ranks), offsets(ranks, 0);
    MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, lmp()->world);
    for (int r = 1; r < ranks; r++) offsets[r] = offsets[r - 1] + sizes[r - 1];
    std::vector<double> all(offsets.back() + sizes.back());
    MPI_Allgatherv(own.data(), size, MPI_DOUBLE, all.data(), sizes.data(), offsets.data(), MPI_DOUBLE, lmp()->world);
    State state;
    for (std::size_t k = 0; k < all.size(); k += 7)
      std::copy_n(all.begin() + k + 1, 6, state[static_cast<int>(all[k])].begin());
    return state;
  }

  /// Force on all atoms by tag, on every rank.
  std::map<int, std::array<double, 2>> forces() const
  {
    std::vector<double> all(2 * (atom()->natoms + 1), 0.0);
    for (int i = 0; i < atom()->nlocal; i++)
      for (int d = 0; d < 2; d++) all[2 * atom()->tag[i] + d] = atom()->f[i][d];
    MPI_Allreduce(MPI_IN_PLACE, all.data(), all.size(), MPI_DOUBLE, MPI_SUM, lmp()->world);
    std::map<int, std::array<double, 2>> forces;
    for (int tag = 1; tag <= atom()->natoms; tag++) forces[tag] = {all[2 * tag], all[2 * tag + 1]};
    return forces;
  }

  /// Sets positions and velocities of own atoms: change(tag, x, v).
  template <typename Change>
  void change(const Change &change)
  {
    for (int i = 0; i < atom()->nlocal; i++) change(atom()->tag[i], atom()->x[i], atom()->v[i]);
  }

private:
  void *handle_ = nullptr;
};

inline int rank()
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

inline int ranks()
{
  int ranks;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

/// Largest difference of any value of any atom; also a failure when the atoms are not the same.
inline double largest_difference(const DryScene::State &a, const DryScene::State &b)
{
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (const auto &[tag, values] : a) {
    const auto other = b.find(tag);
    if (other == b.end()) {
      ADD_FAILURE() << "atom " << tag << " is missing";
      continue;
    }
    for (std::size_t k = 0; k < values.size(); k++) {
      const double difference = std::abs(values[k] - other->second[k]);
      if (!(difference <= largest)) largest = difference;  // also when it is not a number
    }
  }
  return largest;
}

}  // namespace swellflow_test
