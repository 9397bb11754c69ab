! SPDX-License-Identifier: BSD-3-Clause
! The laboratory, by the low-level interface.
module fortran_test_laboratory
  use, intrinsic :: iso_c_binding
  use, intrinsic :: iso_fortran_env, only: int64, real64
  use fortran_test_support, only: case_file, expect
  use hfrac
  implicit none
  private
  public :: rock_tests

contains

  subroutine rock_tests()
    use hfrac_c, only: hfrac_sim_def, hfrac_sim_def_init, hfrac_lab_spec, hfrac_lab_spec_init, hfrac_lab_report, &
      hfrac_lab_run, hfrac_lab_get_report, hfrac_lab_copy_f64, hfrac_lab_destroy, hfrac_targets, hfrac_targets_init, &
      hfrac_calibration, hfrac_calibrate, HFRAC_LAB_CRACKS
    type(hfrac_sim_def) :: def
    type(hfrac_lab_spec) :: spec
    type(hfrac_lab_report) :: report
    type(hfrac_targets) :: targets
    type(hfrac_calibration) :: found
    type(c_ptr) :: lab
    integer(c_int64_t) :: count
    lab = c_null_ptr
    call expect(hfrac_sim_def_init(def, int(c_sizeof(def), c_int32_t)) == 0, 'defaults of a definition')
    call expect(hfrac_lab_spec_init(spec, int(c_sizeof(spec), c_int32_t)) == 0, 'defaults of a test')
    spec%disc_count = 500
    call expect(hfrac_lab_run(def, spec, c_null_funptr, c_null_ptr, lab) == 0, 'a rock test')
    call expect(hfrac_lab_get_report(lab, report) == 0, 'its report')
    call expect(report%modulus > 10e9_c_double .and. report%modulus < 18e9_c_double, 'rock has a modulus')
    call expect(hfrac_lab_copy_f64(lab, HFRAC_LAB_CRACKS, c_null_ptr, 0_c_int64_t, count) == 0, 'its cracks')
    call expect(count == 0, 'nothing breaks in an elastic test')
    call expect(hfrac_lab_destroy(lab) == 0, 'the end of a test')
    call expect(hfrac_targets_init(targets, int(c_sizeof(targets), c_int32_t)) == 0, 'defaults of targets')
    targets%modulus = 20e9_c_double
    targets%disc_count = 500
    targets%packings = 1
    call expect(hfrac_calibrate(def, targets, c_null_funptr, c_null_ptr, found) == 0, 'a calibration')
    call expect(found%test_count == 2, 'of two tests')
  end subroutine rock_tests

end module fortran_test_laboratory
