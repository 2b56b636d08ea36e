// Signals that ask a run to save its state. A handler may only take a note; StopRequest looks at the notes of all ranks together.
#pragma once

namespace swellflow::stop_signals {

enum Wish { nothing, save, save_and_stop };

/// From now on SIGINT, SIGTERM and SIGUSR2 ask for a restart file and the end, and end the program at once when they come again; SIGUSR1 asks for a restart file only.
void handle();
/// What this rank was asked for.
Wish wish();
/// The ranks agreed on it: the next signal is the second on those too that did not get the first.
void agreed(Wish);
/// All is saved. An mpirun that ends its ranks no longer answers them, and MPI_Finalize would wait until they are killed: from now on it has a third of their grace.
void limit_finalize();

}  // namespace swellflow::stop_signals
