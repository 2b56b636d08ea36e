// VTK reports failures on standard error, on every rank; our own errors say more, once.
#pragma once

#include <vtkObject.h>

namespace swellflow {

class QuietVtk {
public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk &) = delete;
  QuietVtk &operator=(const QuietVtk &) = delete;

private:
  int before_;
};

}  // namespace swellflow
