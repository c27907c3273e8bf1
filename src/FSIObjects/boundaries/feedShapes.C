// SPDX-License-Identifier: GPL-3.0-or-later

#include "feedShapes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::feedShapes::setNext()
{
    scalar most = -GREAT;
    const scalar number = nFed() + 1;
    forAll(nFed_, i)
    {
        const scalar behind = number*given_.parts[i] - nFed_[i];
        if (behind > most + SMALL*number)
        {
            most = behind;
            next_ = i;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::feedShapes::feedShapes
(
    const population& objects,
    const dictionary& dict
)
:
    objects_(objects),
    given_
    (
        dict,
        objects.shapeNames(),
        "; shapes that are only fed need an entry in seedObjectsDict without a"
        " placement"
    ),
    nFed_(given_.shapes.size(), 0),
    next_(0)
{
    for (const label groupi : given_.shapes)
    {
        const shapeTemplate& shape = objects.shape(groupi);
        surfaces_.emplace_back(shape.boundaryPoints(), shape.faces());
    }
    setNext();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::feedShapes::advance(const label number)
{
    for (label i = 0; i < number; ++i)
    {
        ++nFed_[next_];
        setNext();
    }
}


// ************************************************************************* //
