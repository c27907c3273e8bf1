// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactScales.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::contactScales::stiffness(const dictionary& dict) const
{
    const word key("stiffness");
    const bool soft = youngsModulus > 0;
    const scalar value =
        soft
      ? readPositive(dict, key, youngsModulus)
      : readPositive(dict, key);
    const scalar most = soft ? 1e6*youngsModulus : 1e12;
    if (value > most)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in dictionary " << dict.name() << " is "
            << value << " Pa but must be at most " << most << " Pa, "
            << (soft ? "1e6 times the least E of the bodies" : "as of diamond")
            << ": a stiffer law turns errors of gaps into speeds"
            << exit(FatalIOError);
    }
    return value;
}


// ************************************************************************* //
