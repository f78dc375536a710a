#ifndef MoteHDF5Handle_h
#define MoteHDF5Handle_h

#include "vtk_hdf5.h"

namespace mote
{

/// Something of HDF5 that has to be closed; below 0 where it could not be opened.
class HDF5Handle
{
public:
  HDF5Handle(hid_t id, herr_t (*close)(hid_t))
    : m_id(id)
    , m_close(close)
  {
  }
  ~HDF5Handle()
  {
    if (m_id >= 0)
      m_close(m_id);
  }
  HDF5Handle(const HDF5Handle&) = delete;
  HDF5Handle& operator=(const HDF5Handle&) = delete;

  operator hid_t() const { return m_id; }
  bool isGood() const { return m_id >= 0; }

private:
  hid_t m_id;
  herr_t (*m_close)(hid_t);
};

/// HDF5 prints nothing meanwhile.
class HDF5Silence
{
public:
  HDF5Silence()
  {
    H5Eget_auto2(H5E_DEFAULT, &m_function, &m_data);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~HDF5Silence() { H5Eset_auto2(H5E_DEFAULT, m_function, m_data); }
  HDF5Silence(const HDF5Silence&) = delete;
  HDF5Silence& operator=(const HDF5Silence&) = delete;

private:
  H5E_auto2_t m_function = nullptr;
  void* m_data = nullptr;
};

} // namespace mote

#endif
