// SPDX-License-Identifier: GPL-3.0-or-later

#include "stepRecord.H"
#include "csvTable.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fsi::stepRecord::columns()
{
    return wordList
    ({
        "time", "deltaT", "objects", "contacts", "smallestGap",
        "kineticEnergy", "elasticEnergy", "contactEnergy", "areaChange",
        "misfit", "rebuilds", "fluidSeconds", "pressureSeconds",
        "levelSetSeconds", "solidsSeconds", "contactSeconds", "couplingSeconds",
        "removed", "fed", "maxSpeed",
        "fluidVelocityX", "fluidVelocityY", "fluidVelocityZ",
        "objectVelocityX", "objectVelocityY", "objectVelocityZ"
    });
}


void Foam::fsi::stepRecord::write(csvTable& table) const
{
    csvTable::rowWriter row(table);
    row << time << deltaT << objects << contacts << smallestGap
        << kineticEnergy << elasticEnergy << contactEnergy << areaChange
        << misfit << rebuilds;
    for (const scalar s : seconds)
    {
        row << s;
    }
    row << removed << fed << maxSpeed << fluidVelocity << objectVelocity;
}


void Foam::fsi::stepRecord::log(Ostream& os, const stepTimer& timer) const
{
    os  << "Objects: " << objects;
    if (removed + fed > 0)
    {
        os  << ", removed " << removed << ", fed " << fed;
    }
    os  << ", contacts " << contacts;
    if (smallestGap < GREAT)
    {
        os  << ", smallest gap " << smallestGap;
    }
    os  << ", largest speed " << maxSpeed
        << ", kinetic energy " << kineticEnergy
        << ", elastic energy " << elasticEnergy
        << ", contact energy " << contactEnergy
        << ", area change " << areaChange
        << ", misfit/h " << misfit
        << ", rebuilds " << rebuilds
        << ", step " << timer.stepSeconds() << " s"
        << ", remaining " << stepTimer::clockString(timer.remaining()).c_str()
        << endl;
}


// ************************************************************************* //
