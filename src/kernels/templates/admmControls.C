// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmControls.H"
#include "openfoamVersion.H"
#include "readBetween.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::admmControls::admmControls
(
    const dictionary& dict,
    const direction nDims,
    const bool held
)
:
    quasiNewton
    (
        readChoice(dict, "scheme", "quasiNewton", {"ADMM", "quasiNewton"})
     == "quasiNewton"
    ),
    iterations
    (
        readBetween
        (
            dict, "iterations", held ? 200 : quasiNewton ? 8 : 10, 1, 100000
        )
    ),
    tolerance(readNonNegative(dict, "tolerance", held ? 1e-9 : 0)),
    springWeight
    (
        readPositive(dict, "springWeight", quasiNewton ? 1.0/nDims : 1)
    ),
    areaWeight
    (
        readPositive(dict, "areaWeight", quasiNewton ? 0.5/nDims : 0.5)
    ),
    conserving
    (
        readChoice
        (
            dict, "rotation", "conserving", {"conserving", "implicitEuler"}
        ) == "conserving"
    )
{
    checkKeys
    (
        dict,
        {
            "scheme", "iterations", "tolerance", "springWeight", "areaWeight",
            "rotation"
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::admmControls::write(Ostream& os) const
{
    beginDict(os, "admm");
    putEntry(os, "scheme", word(quasiNewton ? "quasiNewton" : "ADMM"));
    putEntry(os, "iterations", iterations);
    putEntry(os, "tolerance", tolerance);
    putEntry(os, "springWeight", springWeight);
    putEntry(os, "areaWeight", areaWeight);
    putEntry
    (
        os,
        "rotation",
        word(conserving ? "conserving" : "implicitEuler")
    );
    endDict(os);
}


// ************************************************************************* //
