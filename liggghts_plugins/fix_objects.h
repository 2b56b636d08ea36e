// The internal fix that knows which atoms are points of which object, on this rank, and keeps LIGGGHTS' cut-offs wide
// enough for objects that grow. create_objects makes it, or the first of our fixes after a read_restart.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "fluid_partner.h"
#include "step_clock.h"
#include "worst_object.h"

namespace LAMMPS_NS {

class FixPropertyAtom;
class ProgressLine;

class FixObjects : public Fix {
 public:
  /// Columns of the per-atom vector `object_point`; all are zero for an atom that is not a point of an object.
  enum Column {
    RING_POINTS,       // N; 0 marks all other atoms
    INDEX,             // -1 hub, 0 .. N-1 ring, counter-clockwise
    SPOKES,            // 1: springs join ring and hub; 0: the hub only follows the ring's mean
    OUTLINE_OFFSET,    // by which the outline lies beyond the ring point, away from the hub, at lambda = 1
    DIAMETER,          // natural diameter at creation: that of the disc of the same area
    START_DIAMETER,    // natural diameter when the present swelling law began; 0: none has
    START_TIME,        // the clock of its fix then, and the time that the object has lost since then because load slows it down
    RATE_FACTOR,       // of the object's swelling law: its speed over that of the law
    SIZE_FACTOR,       // its growth over that of the law
    OBJECT_MASS,       // of all points of the object together, at lambda = 1
    NATURAL_AREA,      // inside the polygon of the outline, at lambda = 1
    MEAN_SQUARE_RADIUS,  // of the area of the smooth shape about its centroid, at lambda = 1
    SPOKE_LENGTH,      // natural length of the spoke to the hub at lambda = 1, ring points only
    RING_LENGTH,       // natural length to the next ring point at lambda = 1, ring points only
    REST_X,            // undeformed position about the centre of mass, at lambda = 1 and as the object was made
    REST_Y,
    HAS_CDS,           // 0: the point takes part in no contact; its radius is a token
    ROTATION,          // angle by which the object has turned since it was made, not wrapped
    N_COLUMNS,
    LONGEST_SIDE = RING_LENGTH  // hubs have that of their outline there, at lambda = 1
  };
  /// Columns of the per-atom vector `object_size`, which swelling goes through in each DEM step; all are zero for other atoms.
  enum SizeColumn {
    LAMBDA,            // natural swelling ratio
    CDS_RADIUS,        // at lambda = 1
    MASS,              // at lambda = 1
    N_SIZES
  };
  static constexpr const char *ID = "objects";
  static constexpr const char *PROPERTY = "object_point";
  static constexpr const char *SIZES = "object_size";
  static constexpr const char *GROUP_WITHOUT_CDS = "without_cds";  // all points with HAS_CDS 0

  FixObjects(class LAMMPS *, int, char **);
  ~FixObjects() override;

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup_pre_exchange() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void setup_pre_neighbor() override;
  void setup(int) override;
  void setup_pre_force(int) override;
  void pre_initial_integrate() override;
  void pre_exchange() override;
  void pre_neighbor() override;
  void pre_force(int) override;
  void end_of_step() override;
  void post_run() override;
  double max_rad(int type) override;
  int pack_comm(int n, int *list, double *buf, int pbc_flag, int *pbc) override;
  void unpack_comm(int n, int first, double *buf) override;
  // For atoms with a radius LIGGGHTS sends only what lies within half of this (plus radius and skin) of a border.
  double extend_cut_ghost() override { return 2.0 * ghost_reach_; }

  /// All objects with an own point on this rank. Indices may be ghosts: for each object, of the image that is nearest to
  /// one of its own points. Valid from the reneighbouring of a step until the next.
  const std::vector<swellflow::ObjectPoints> &objects() const { return objects_; }
  /// Another one whenever that list is made anew.
  int list_number() const { return list_number_; }
  /// Whether this rank is the one that counts and writes this object.
  bool owns(const swellflow::ObjectPoints &object) const;
  /// The own atom that is the same point as atom `i` (own or ghost), or -1 when another rank owns it.
  int own_index(int i) const;
  /// The columns above, for own and ghost atoms. May move when atoms migrate: take it anew each step.
  double **points() const;
  double **sizes() const;
  bool is_point(int i) const { return points()[i][RING_POINTS] > 0.0; }
  /// Whether it is a hub without spokes, which is set to the mean of its ring in every step and must not be integrated.
  bool follows_its_ring(int i) const;
  /// Whether there are any on any rank, since the last reneighbouring.
  bool some_follow_their_ring() const { return some_follow_; }
  /// Of the hub of the object that point `i` belongs to.
  int tag_of_hub(int i) const;
  /// Whether objects() agrees with LIGGGHTS' arrays: not before the first run, nor after a command has moved atoms about.
  bool current() const;
  /// Whether this holds on all ranks, so that objects can be measured and ghosts be sent to. Collective.
  bool current_everywhere() const;
  /// Brings the column ROTATION up to date, for all points of all objects on this rank. Turns are counted as long as no object turns by half a turn between two
  /// calls: one is made whenever LIGGGHTS makes new neighbour lists, which is when a point has moved by half the skin.
  void update_rotations();
  /// Error when a group holds some points of an object but not all. Collective, after the first neighbouring.
  void require_whole_objects(const Fix &asking) const;

  /// Points without a sphere become a group, and LIGGGHTS is told to keep them out of neighbour lists. Collective, before lists are set up.
  void exclude_points_without_spheres();

  /// `width` values an atom, at most 3, own atoms and then ghosts: each ghost gets those of its own atom. Collective.
  void send_to_ghosts(double *values, int width);

  swellflow::StepClock &clock() { return clock_; }

 private:
  bool represents_its_object(int i) const;
  bool find_points(int i, int &hub, int *ring) const;
  void list_objects();

  enum Count { POINTS, OBJECTS, SUM_OF_IDS, TORN, FOLLOW, N_COUNTS };
  using Counts = std::array<bigint, N_COUNTS>;
  Counts own_counts() const;
  void require_all_points(const Counts &now);
  void require_same_fixes();

  void choose_sort_bins();
  void require_ghost_velocities();
  void hubs_follow();
  void hubs_follow_early();
  bool overlap_by_design(int i, int j) const;
  void require_exclusions();

  enum Measure { ACROSS_X, ACROSS_Y, REACH, N_MEASURES };
  using Extents = std::array<WorstObject, N_MEASURES>;
  struct Part;
  static void include(Extents &largest, const Extents &other);
  static void merge(Part &whole, const Part &part);
  void add_point(Part &part, int i, const double *x) const;
  std::vector<Part> unwrapped_parts() const;
  Extents extents_of_own_objects() const;
  Extents extents_of_unwrapped_objects() const;
  bool is_finite(int i) const;
  void fail_not_finite(int object);
  void require_sane(Extents &largest);
  double widest_allowed(int d) const;
  bool widen_cutoffs(double widest_object);
  bool raise_radius_caps();
  void renew_neighbor_lists();

  FixPropertyAtom *property_, *sizes_;
  std::vector<swellflow::ObjectPoints> objects_;
  std::vector<int> ring_indices_;
  bool excludes_ = false;           // neighbour lists leave out GROUP_WITHOUT_CDS
  int listed_atoms_ = 0, listed_ghosts_ = 0;  // when objects_ was made
  int list_number_ = 0;
  bool some_follow_ = false;
  bigint followed_at_ = -1;         // step at which hubs have followed before points went to other ranks
  Counts counts_;                   // on all ranks, when the run or the last reneighbouring began
  std::vector<const Fix *> fixes_;  // when the run began
  std::vector<double> radius_cap_;  // per type, what max_rad returns
  double own_bin_size_ = 0.0;       // of the bins in which LIGGGHTS sorts atoms, when it was chosen here
  double ghost_reach_;
  double *sent_ = nullptr;          // what is being sent to ghosts, for pack_comm and unpack_comm
  int sent_width_ = 0;
  swellflow::StepClock clock_;
  std::unique_ptr<ProgressLine> progress_;
};

/// The internal fix, or null when a scene has no objects.
FixObjects *find_objects(class LAMMPS *);
/// The internal fix, made when it is missing. Collective.
FixObjects *make_objects(class LAMMPS *);
/// For a fix that works on objects: the internal fix, made anew when a restart file brought the objects; a LIGGGHTS error
/// that names `asking` when there are none. To be called in post_create. Collective.
FixObjects *require_objects(class LAMMPS *, const Fix &asking);
/// Rule, value and remedy of the first setting that forbids objects, or nothing.
std::string why_no_objects(class LAMMPS *);

}  // namespace LAMMPS_NS
