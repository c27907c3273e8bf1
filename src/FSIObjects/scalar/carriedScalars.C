// SPDX-License-Identifier: GPL-3.0-or-later

#include "carriedScalars.H"
#include "dictionaryCheck.H"
#include "fsiObjects.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::carriedScalars::carriedScalars
(
    fsiObjects& objects,
    const interfaceGeometry& geometry
)
{
    const dictionary& dict = objects.properties().subOrEmptyDict("scalars");
    const wordList names(dict.toc());
    checkSubDicts(dict, names);
    scalars_.setSize(names.size());
    forAll(names, i)
    {
        scalars_.set
        (
            i,
            new carriedScalar
            (
                objects, geometry, names[i], dict.subDict(names[i])
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsi::carriedScalars::buoyant() const
{
    for (const carriedScalar& scalar : scalars_)
    {
        if (scalar.buoyant())
        {
            return true;
        }
    }
    return false;
}


void Foam::fsi::carriedScalars::addBuoyancy(vectorField& source) const
{
    for (const carriedScalar& scalar : scalars_)
    {
        scalar.addBuoyancy(source);
    }
}


void Foam::fsi::carriedScalars::advance(const surfaceScalarField& phi)
{
    for (carriedScalar& scalar : scalars_)
    {
        scalar.advance(phi);
    }
}


// ************************************************************************* //
