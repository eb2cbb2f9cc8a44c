# changeover_use_mpi(<target>): lets mpirun start several processes of one job, if MPI is there when
# this is configured. Defines CHANGEOVER_WITH_MPI; without MPI the target is alone.
option(CHANGEOVER_MPI "Let mpirun start several processes of one job" ON)

function(changeover_use_mpi target)
  if(NOT CHANGEOVER_MPI)
    return()
  endif()
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND)
    target_link_libraries(${target} PRIVATE MPI::MPI_CXX)
    # Without the C++ bindings, which MPI has dropped.
    target_compile_definitions(${target} PRIVATE
      CHANGEOVER_WITH_MPI OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
  endif()
endfunction()
