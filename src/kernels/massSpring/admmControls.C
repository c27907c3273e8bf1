// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmControls.H"
#include "dictionaryCheck.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::admmControls::admmControls(const dictionary& dict)
:
    iterations(dict.lookupOrDefault<label>("iterations", 10)),
    tolerance(readNonNegative(dict, "tolerance", 0)),
    springWeight(readPositive(dict, "springWeight", 1)),
    areaWeight(readPositive(dict, "areaWeight", 0.5)),
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
        {"iterations", "tolerance", "springWeight", "areaWeight", "rotation"}
    );
    if (iterations < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'iterations' in dictionary " << dict.name() << " is "
            << iterations << " but must be > 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::admmControls::write(Ostream& os) const
{
    os.beginBlock("admm");
    os.writeEntry("iterations", iterations);
    os.writeEntry("tolerance", tolerance);
    os.writeEntry("springWeight", springWeight);
    os.writeEntry("areaWeight", areaWeight);
    os.writeEntry
    (
        "rotation",
        word(conserving ? "conserving" : "implicitEuler")
    );
    os.endBlock();
}


// ************************************************************************* //
