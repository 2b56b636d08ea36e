// The state of a fluid in a file: named arrays of numbers, which any number of ranks can read.
#pragma once

#include <mpi.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "fluid/field.h"

namespace swellflow {

/// What is kept tells its state once, by names, and a checkpoint either notes it or sets it. All calls are collective, in the same order on all ranks.
class Checkpoint {
public:
  virtual ~Checkpoint() = default;
  virtual bool loads() const = 0;

  /// Numbers that are the same on all ranks.
  virtual void common(const std::string &name, double *values, int n) = 0;
  void number(const std::string &name, double &value) { common(name, &value, 1); }
  void flag(const std::string &name, bool &value)
  {
    double number = value;
    common(name, &number, 1);
    value = number != 0.0;
  }

  /// This rank's parts of sums over all ranks, or of maxima. On as many ranks as before each has its own again, else the first has what all had.
  enum class Of { sum, maximum };
  virtual void parts(const std::string &name, double *values, int n, Of of = Of::sum) = 0;

  /// This rank's part of an array that lies on all ranks in their order: blocks first … first + count - 1 of `total`, each of `size` numbers.
  struct Part {
    int first, count, total;
    std::size_t size;
  };
  virtual void array(const std::string &name, double *values, const Part &part) = 0;

  /// The own planes of a field, their side ghosts included; `top`: and the plane above the last one, which has the faces of the upper end.
  template <int Dim> void planes(const std::string &name, Field<Dim> &field, const Grid<Dim> &grid, const Layout<Dim> &layout, bool top = false)
  {
    const bool has_top = top && grid.rank == grid.ranks - 1;
    array(name, field.data() + layout.plane_begin(0),
          {grid.first_plane, grid.planes + has_top, grid.cells[Grid<Dim>::last] + top, static_cast<std::size_t>(layout.plane_stride())});
  }
};

/// Appends to a file that rank 0 writes.
class CheckpointWriter : public Checkpoint {
public:
  /// Throws std::runtime_error on all ranks when the file cannot be opened.
  CheckpointWriter(const std::string &file, MPI_Comm comm);
  ~CheckpointWriter() override;
  CheckpointWriter(const CheckpointWriter &) = delete;
  CheckpointWriter &operator=(const CheckpointWriter &) = delete;

  bool loads() const override { return false; }
  void common(const std::string &name, double *values, int n) override;
  void parts(const std::string &name, double *values, int n, Of of) override;
  void array(const std::string &name, double *values, const Part &part) override;
  /// Throws std::runtime_error on all ranks when not everything could be written.
  void close();

private:
  void begin(const std::string &name, std::size_t count);
  void put(const void *data, std::size_t bytes);

  std::string name_;
  MPI_Comm comm_;
  int rank_ = 0, ranks_ = 1;
  std::FILE *file_ = nullptr;
  bool good_ = true;
};

/// Reads what a writer appended, from byte `begin` up to `end`. Throws std::invalid_argument, on all ranks alike, when what is asked for is not there.
class CheckpointReader : public Checkpoint {
public:
  CheckpointReader(const std::string &file, long begin, long end, MPI_Comm comm);
  ~CheckpointReader() override;
  CheckpointReader(const CheckpointReader &) = delete;
  CheckpointReader &operator=(const CheckpointReader &) = delete;

  bool loads() const override { return true; }
  bool has(const std::string &name) const { return entries_.contains(name); }
  void common(const std::string &name, double *values, int n) override;
  void parts(const std::string &name, double *values, int n, Of of) override;
  void array(const std::string &name, double *values, const Part &part) override;

private:
  struct Entry {
    long at;
    std::size_t count;
  };
  void scan(long begin, long end);
  void share_entries();
  const Entry &entry(const std::string &name, std::size_t count) const;
  void get(long at, double *values, std::size_t count);

  std::string name_;
  MPI_Comm comm_;
  int rank_ = 0, ranks_ = 1;
  std::FILE *file_ = nullptr;
  std::map<std::string, Entry> entries_;
};

}  // namespace swellflow
